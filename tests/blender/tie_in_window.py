"""Ties a knot in a window as a user does: the dialog, the progress, Esc, and once more until the ribbon is there.

usage: tie_in_window.py PACKAGE IMPORT_ADD_ON ADD_ON RECORDER FOLDER    PACKAGE: folder in which the package ribbon lies
Blender must take simulated events instead of real ones (--enable-event-simulate).
"""

import os
import sys
import time
import traceback
from pathlib import Path

import bpy

package, import_add_on, add_on, recorder, folder = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, package)
folder = Path(folder)

import ribbon  # noqa: E402, found only now

PATIENCE_S = 120
# A loop with both ends outside, in metres seen from above.
LINE = [(-0.2, -0.1), (-0.05, -0.02), (0.08, 0.06), (0.05, 0.12),
        (-0.05, 0.12), (-0.08, 0.06), (0.05, -0.02), (0.2, -0.1)]


def check(claim, text):
    if not claim:
        raise AssertionError(text)


def press(key):
    window = bpy.context.window_manager.windows[0]
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(type=key, value=value, x=window.width // 2, y=window.height // 2)


def view():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    region = next(region for region in area.regions if region.type == "WINDOW")
    return bpy.context.temp_override(window=window, area=area, region=region)


def draw():
    curve = bpy.data.curves.new("loop", "CURVE")
    curve.dimensions = "3D"
    spline = curve.splines.new("POLY")
    spline.points.add(len(LINE) - 1)
    for point, (x, y) in zip(spline.points, LINE):
        point.co = (x, y, 0, 1)
    drawing = bpy.data.objects.new("loop", curve)
    bpy.context.collection.objects.link(drawing)
    choose(drawing)
    return drawing


def choose(thing):
    for other in bpy.context.view_layer.objects:
        other.select_set(other == thing)
    bpy.context.view_layer.objects.active = thing


def ask(**settings):
    window = bpy.context.window_manager.windows[0]
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=window.width // 2, y=window.height // 2)
    with view():
        return bpy.ops.object.tie_ribbon("INVOKE_DEFAULT", folder=str(folder), width=0.01, speed=0.01, **settings)


def is_begun(path):
    try:
        return len(ribbon.open(path)) > 3
    except ribbon.Error:
        return False


def tied():
    return [thing for thing in bpy.context.scene.objects if "ribbon_recording" in thing]


def story():
    """Yields what to wait for."""
    recorded = folder / "loop.rbn"
    drawing = draw()
    ask(duration=1000)
    yield lambda: True
    press("RET")
    yield lambda: is_begun(recorded)
    press("ESC")
    yield lambda: ribbon.open(recorded).ending == "stopped"
    check(not tied(), "what was stopped was imported")
    stopped_at = len(ribbon.open(recorded))

    choose(drawing)
    ask(duration=0.5)
    yield lambda: True
    press("RET")
    yield tied
    check(len(ribbon.open(recorded)) == 26 != stopped_at, "half a second are other frames")
    check(len(tied()[0].data.vertices) == 4 * ribbon.open(recorded).along, "the ribbon is another")

    choose(drawing)
    ask(duration=1000)
    yield lambda: True
    press("RET")
    yield lambda: is_begun(recorded) and ribbon.open(recorded).being_written
    bpy.ops.wm.read_homefile(use_factory_startup=True)
    yield lambda: ribbon.open(recorded).ending == "stopped"


def run(steps=None, waits_for=None, since=0.0):
    """A step of the story, and after a moment the next one."""
    try:
        if waits_for is None or waits_for():
            waits_for, since = next(steps), time.monotonic()
        check(time.monotonic() - since < PATIENCE_S, "nothing came of the last step")
    except StopIteration:
        print("Blender ties in a window.", flush=True)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    bpy.app.timers.register(lambda: run(steps, waits_for, since), first_interval=0.5, persistent=True)


for module in (import_add_on, add_on):
    bpy.ops.preferences.addon_install(filepath=module)
    bpy.ops.preferences.addon_enable(module=Path(module).stem)
bpy.context.preferences.addons["ribbon_knot"].preferences.recorder = recorder
bpy.app.timers.register(lambda: run(story()), first_interval=2)
