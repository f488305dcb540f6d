#!/usr/bin/env python3
"""Builds the programs of docs/library.md outside of the tree, against the installed library, and runs them.

usage: documented_programs.py LIBRARY.md FOLDER SCENE [CMAKE_OPTION...]

ribbon-record must be found in the path; it records SCENE for a moment.
"""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

BLOCK = re.compile(r"^```(?:cpp|cmake)\n(?://|#) ([\w.]+)(.*?)^```$", re.MULTILINE | re.DOTALL)


def extract(document, folder):
    """Writes each program of the document that says its name in its first line."""
    for block in BLOCK.finditer(document.read_text()):
        comment = "#" if block[1].endswith(".txt") else "//"
        (folder / block[1]).write_text(f"{comment} {block[1]}{block[2]}")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def build(folder, options):
    run("cmake", "-S", folder, "-B", folder / "build", "-DCMAKE_BUILD_TYPE=Debug",
        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", *options)
    run("cmake", "--build", folder / "build", "--parallel", "2")
    return folder / "build"


def check(claim, text):
    if not claim:
        sys.exit(f"FAILED: {text}")


def check_own_recording(programs, folder):
    own = folder / "own.rbn"
    run(programs / "write", own)
    lines = run(programs / "read", own).splitlines()
    check(lines == [f"frame {i}: 0.400000 m" for i in range(1, 11)], f"read said {lines}")
    check(run(programs / "verify", own).startswith("0 intersecting pairs, no gap below 7.1"), "verify found other gaps")
    refused = subprocess.run([programs / "write", own], capture_output=True, text=True, check=False)
    check(refused.returncode == 2 and "own.rbn" in refused.stderr, f"write said {refused.stderr}")


def check_growing_recording(programs, folder, scene):
    growing = folder / "growing.rbn"
    recorder = subprocess.Popen(["ribbon-record", scene, "--until", "3", "--quiet", "-o", growing])
    while recorder.poll() is None and subprocess.run([programs / "read", growing], capture_output=True).returncode:
        time.sleep(0.01)
    check(recorder.poll() is None, "the recorder ended before it could be followed")
    lines = run(programs / "follow", growing).splitlines()
    check(recorder.wait() == 0, "the recorder failed")
    frames = len(run(programs / "read", growing).splitlines())
    check(len(lines) == frames + 1 and lines[-1] == "ended: limit", f"of {frames} frames follow said {lines}")


def refusal(*command):
    refused = subprocess.run(command, capture_output=True, text=True, check=False)
    check(refused.returncode == 2, f"{command} ended with {refused.returncode}")
    return refused.stderr


def check_no_recording(programs):
    for program in ("read", "follow", "verify", "write"):
        said = refusal(programs / program)
        check("no recording is named" in said, f"{program} without a name said {said!r}")


def check_bad_recordings(programs, folder):
    nothing, damaged, empty = folder / "nothing.rbn", folder / "damaged.rbn", folder / "empty.rbn"
    damaged.write_bytes(b"no recording" * 100)
    empty.write_bytes((folder / "own.rbn").read_bytes()[:300])
    for program in ("read", "follow", "verify"):
        for path in (nothing, damaged):
            said = refusal(programs / program, path)
            check(str(path) in said, f"{program} {path.name} said {said!r}")
    check(str(empty) in refusal(programs / "verify", empty), "verify said nothing of a recording without a frame")


def check_recording_that_vanishes(programs, folder, scene):
    for name, vanish in (("deleted.rbn", Path.unlink), ("cut.rbn", lambda path: os.truncate(path, 100))):
        path = folder / name
        recorder = subprocess.Popen(["ribbon-record", scene, "--until", "5", "--quiet", "-o", path])
        while recorder.poll() is None and subprocess.run([programs / "read", path], capture_output=True).returncode:
            time.sleep(0.01)
        follower = subprocess.Popen([programs / "follow", path], text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        follower.stdout.readline()
        recorder.send_signal(signal.SIGSTOP)  # so that it does not write over the gap
        vanish(path)
        if name == "deleted.rbn":
            recorder.send_signal(signal.SIGCONT)
            recorder.send_signal(signal.SIGTERM)
        said, refused = follower.communicate()
        recorder.kill()
        recorder.wait()
        if name == "deleted.rbn":
            check(follower.returncode == 0 and said.endswith("ended: unknown\n"), f"{name}: {said[-80:]}, {refused}")
        else:
            check(follower.returncode == 2 and "has become shorter" in refused, f"{name}: {said[-80:]}, {refused}")


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    document, folder, scene = (Path(word) for word in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.rbn"):
        old.unlink()
    extract(document, folder)
    programs = build(folder, sys.argv[4:])
    check_own_recording(programs, folder)
    check_growing_recording(programs, folder, scene)
    check_no_recording(programs)
    check_bad_recordings(programs, folder)
    check_recording_that_vanishes(programs, folder, scene)
    print("The documented programs work.")


if __name__ == "__main__":
    main()
