"""Writes the sample scenes that need meshes: a skirt of two layers on a body, two elastic balls.
usage: scene_meshes.py samples/scenes"""

import math
import os
import sys


def number(x):
    text = f"{x:.5f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text


def write_obj(path, vertices, faces):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines("v " + " ".join(map(number, v)) + "\n" for v in vertices)
        file.writelines("f " + " ".join(str(i + 1) for i in face) + "\n" for face in faces)


def cone(around, rows, waist, hem, length):
    """An open cone, the waist at height 0, row by row downwards."""
    vertices = []
    for r in range(rows):
        part = r / (rows - 1)
        radius = waist + (hem - waist) * part
        for c in range(around):
            angle = 2 * math.pi * c / around
            vertices.append((radius * math.cos(angle), -length * part, radius * math.sin(angle)))
    faces = []
    for r in range(rows - 1):
        for c in range(around):
            i, j = r * around + c, r * around + (c + 1) % around
            faces.append((i, j, j + around, i + around))
    return vertices, faces


def ball(subdivisions):
    """An icosahedron divided on the unit sphere."""
    g = (1 + math.sqrt(5)) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    vertices = [unit(v) for v in vertices]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(vertices)
                vertices.append(unit([a + b for a, b in zip(vertices[i], vertices[j])]))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return vertices, faces


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def pins(vertices, around, scale, angle, omega):
    """The waist turns to and fro: each vertex along its tangent."""
    groups = []
    for i in range(around):
        x, _, z = vertices[i]
        amplitude = ", ".join(number(a) for a in (-z * scale * angle, 0, x * scale * angle))
        groups.append(f'        {{ "vertices": [{i}], "motion": {{ "amplitude": [{amplitude}], '
                      f'"omega": {omega} }} }}')
    return ",\n".join(groups)


def skirt_layer(name, vertices, around, scale, distance, mass):
    return f"""    {{
      "name": "{name}",
      "mesh": {{ "file": "skirt.obj", "bend": true }},
      "transform": {{ "scale": {scale}, "translate": [0, 0.85, 0] }},
      "mass": {mass},
      "stiffness": {{ "stretch": 60, "bend": 0.4 }},
      "damping": {{ "drag": 2e-5, "spring": 0.001 }},
      "collision": {{ "distance": {distance} }},
      "pins": [
{pins(vertices, around, scale, 0.6, 4)}
      ]
    }}"""


def write_skirt(folder):
    around = 72
    vertices, faces = cone(around, 30, 0.135, 0.27, 0.5)
    write_obj(os.path.join(folder, "skirt.obj"), vertices, faces)
    layers = [skirt_layer("skirt", vertices, around, 1.12, 0.016, 0.2),
              skirt_layer("lining", vertices, around, 1.0, 0.0145, 0.15)]
    with open(os.path.join(folder, "skirt.json"), "w", encoding="utf-8") as file:
        file.write("""{
  "weft": 1,
  "time": { "duration": 4.0 },
  "cloths": [
""" + ",\n".join(layers) + """
  ],
  "colliders": [
    { "capsule": { "a": [0, 0.1, 0], "b": [0, 0.95, 0], "radius": 0.115 }, "friction": 0.2 },
    { "plane": { "normal": [0, 1, 0], "offset": 0 }, "friction": 0.4 }
  ],
  "self_collision": { "method": "complete", "distance": 0.015, "friction": 0.2 }
}
""")


def ball_cloth(name, mass, place, push):
    """Pushed, and carried, at 42 vertices all around: those of the first division."""
    force = ", ".join(number(mass * f / 42) for f in (push[0], push[1] + 9.81, push[2]))
    return f"""    {{
      "name": "{name}",
      "mesh": {{ "file": "ball.obj", "bend": true }},
      "transform": {{ "scale": 0.15, "translate": [{", ".join(map(str, place))}] }},
      "mass": {mass},
      "stiffness": {{ "stretch": 40, "bend": 40 }},
      "damping": {{ "drag": 1e-4, "spring": 0.004 }},
      "collision": {{ "distance": 0.02 }},
      "forces": [ {{ "force": [{force}], "vertices": [{", ".join(map(str, range(42)))}] }} ]
    }}"""


def write_balls(folder):
    vertices, faces = ball(3)
    write_obj(os.path.join(folder, "ball.obj"), vertices, faces)
    balls = [ball_cloth("left", 0.12, [-0.16, 0.62, 0.35], [0.8, 0, -5]),
             ball_cloth("right", 0.12, [0.16, 0.76, -0.35], [-1.5, 0, 4])]
    with open(os.path.join(folder, "balls.json"), "w", encoding="utf-8") as file:
        file.write("""{
  "weft": 1,
  "time": { "duration": 3.0 },
  "cloths": [
    {
      "name": "curtain",
      "grid": { "rows": 88, "columns": 96, "width": 1.2, "height": 1.1, "stencil": "classic12" },
      "transform": { "translate": [-0.6, 0.15, 0] },
      "mass": 0.4,
      "stiffness": { "stretch": 60, "shear": 20, "bend": 0.5 },
      "damping": { "drag": 2e-5, "spring": 0.0005 },
      "collision": { "distance": 0.0133 },
      "pins": [ { "rows": [0, 87] } ]
    },
""" + ",\n".join(balls) + """
  ],
  "colliders": [ { "plane": { "normal": [0, 1, 0], "offset": 0 }, "friction": 0.4 } ],
  "camera": { "eye": [2.3, 1.25, 2.1], "target": [0, 0.68, 0] },
  "wind": { "velocity": [0.5, 0, 1.5] },
  "self_collision": { "method": "complete", "distance": 0.0133, "friction": 0.2 }
}
""")


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    write_skirt(arguments[0])
    write_balls(arguments[0])


main(sys.argv[1:])
