"""Writes scenes again without self-collision, to compare, and prints the paths of all: each scene,
and behind it the one without. usage: demo_scenes.py OUT SCENE.json..."""

import json
import os
import sys


def absolute_meshes(shapes, folder):
    for shape in shapes:
        if "mesh" in shape:
            shape["mesh"]["file"] = os.path.abspath(os.path.join(folder, shape["mesh"]["file"]))


def main(arguments):
    if len(arguments) < 2:
        sys.exit(__doc__)
    out, scenes = arguments[0], arguments[1:]
    for path in scenes:
        print(path)
        with open(path, encoding="utf-8") as file:
            scene = json.load(file)
        if scene.get("self_collision") is None:
            continue
        scene["self_collision"] = None
        absolute_meshes(scene["cloths"] + scene.get("colliders", []), os.path.dirname(path))
        name = os.path.splitext(os.path.basename(path))[0]
        without = os.path.join(out, name + "_without.json")
        with open(without, "w", encoding="utf-8") as file:
            json.dump(scene, file)
        print(without)


main(sys.argv[1:])
