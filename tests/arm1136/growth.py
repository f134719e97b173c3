#!/usr/bin/env python3
"""growth.py COUNTER COMMAND...: prints TAP. `limber doctor`, which COMMAND runs
for ARM, takes as many instructions again for a model with twice as many skins,
clips, channels or meshes. COUNTER is the plugin of insn_count.c; the numbers of
instructions are the same at any load.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

COUNT = 600
MOST = 2.1

ZEROS = {"componentType": 5126, "count": 3}
BYTES = "data:application/octet-stream;base64,AAAAAAAAgD8="


def model(count, **members):
    """A model of so many nodes in its scene."""
    return {
        "asset": {"version": "2.0"}, "scenes": [{"nodes": list(range(count))}],
        "nodes": [{}] * count,
        "buffers": [{"byteLength": 8, "uri": BYTES}],
        "bufferViews": [{"buffer": 0, "byteLength": 8}],
        "accessors": [{**ZEROS, "type": "VEC3"},
                      {**ZEROS, "type": "VEC4", "componentType": 5121},
                      {**ZEROS, "type": "VEC4"},
                      {"componentType": 5126, "count": 2, "type": "SCALAR",
                       "bufferView": 0},
                      {"componentType": 5126, "count": 2, "type": "VEC3"}],
        **members}


def skins(count):
    """Each has a joint of its own."""
    return model(count, skins=[{"joints": [i]} for i in range(count)])


def clips(count):
    """All move the same node."""
    return model(count, animations=[{
        "samplers": [{"input": 3, "output": 4}],
        "channels": [{"sampler": 0,
                      "target": {"node": 0, "path": "translation"}}],
    }] * count)


def channels(count):
    """One clip moves all nodes."""
    return model(count, animations=[{
        "samplers": [{"input": 3, "output": 4}],
        "channels": [{"sampler": 0,
                      "target": {"node": i, "path": "translation"}}
                     for i in range(count)]}])


def meshes(count):
    """Each has a node of its own, with the same skin."""
    part = {"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}
    return model(count, skins=[{"joints": [0]}],
                 meshes=[{"primitives": [part]}] * count,
                 nodes=[{"mesh": i, "skin": 0} for i in range(count)])


def instructions(counter, command, path):
    qemu, *others = command
    run = subprocess.run(
        [qemu, "-plugin", counter, "-d", "plugin", *others, "doctor", path],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "LIMBER_CONFIG": "none"}, check=False)
    found = re.search(r"^instructions: (\d+)$", run.stderr, re.M)
    if run.returncode != 0 or not found:
        sys.exit(f"growth.py: limber doctor {path}: {run.stderr}")
    return int(found[1])


def main():
    counter, *command = sys.argv[1:]
    print("1..4")
    with tempfile.TemporaryDirectory() as folder:
        for number, kind in enumerate((skins, clips, channels, meshes), 1):
            counts = []
            for count in (COUNT, 2 * COUNT):
                path = pathlib.Path(folder) / f"{count}.gltf"
                path.write_text(json.dumps(kind(count)))
                counts.append(instructions(counter, command, path))
            grown = counts[1] / counts[0]
            result = "ok" if grown <= MOST else "not ok"
            print(f"{result} {number} - twice as many {kind.__name__} take "
                  f"{grown:.3f} times as many instructions")


if __name__ == "__main__":
    main()
