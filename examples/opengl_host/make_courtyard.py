# SPDX-License-Identifier: MIT
"""Writes courtyard.obj, the scene of this example: boxes, prisms and turned shapes, a colour at each vertex ("v x y z r g b")."""
import math

STONE, SAND, TILE, SLATE = (0.62, 0.58, 0.52), (0.72, 0.62, 0.45), (0.55, 0.42, 0.34), (0.34, 0.36, 0.40)
LEAF, BARK, IRON, WATER = (0.22, 0.42, 0.16), (0.33, 0.22, 0.14), (0.16, 0.16, 0.18), (0.20, 0.42, 0.52)


class Scene:
    def __init__(self):
        self.lines, self.count = [], 0

    def named(self, name):
        self.lines.append(f"o {name}")

    def vertices(self, points, colour):
        first = self.count + 1
        self.count += len(points)
        self.lines += ["v %.4g %.4g %.4g %.3g %.3g %.3g" % (*p, *colour) for p in points]
        return first

    def faces(self, first, faces):
        self.lines += ["f " + " ".join(str(first + i) for i in face) for face in faces]

    def box(self, low, high, colour):
        (x0, y0, z0), (x1, y1, z1) = low, high
        corners = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
        self.faces(self.vertices(corners, colour),
                   [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])

    def turned(self, centre, outline, sides, colour):
        """The outline's (radius, height) pairs, from below to above, turned about the vertical through the centre."""
        x, y, z = centre
        ring = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides)) for i in range(sides)]
        first = self.vertices([(x + r * c, y + h, z + r * s) for r, h in outline for c, s in ring], colour)
        faces = []
        for level in range(len(outline) - 1):
            a, b = level * sides, (level + 1) * sides
            for i in range(sides):
                j = (i + 1) % sides
                faces.append((a + i, b + i, b + j, a + j))
        top = (len(outline) - 1) * sides
        faces.append(tuple(top + i for i in reversed(range(sides))))
        faces.append(tuple(range(sides)))
        self.faces(first, faces)


def courtyard():
    scene = Scene()
    scene.named("ground")
    for i in range(8):
        for j in range(8):
            x, z = -12 + 3 * i, -12 + 3 * j
            scene.box((x, -0.3, z), (x + 2.97, 0, z + 2.97), SAND if (i + j) % 2 else TILE)
    scene.box((-12, -0.4, -12), (12, -0.05, 12), SLATE)

    scene.named("walls")
    scene.box((-12, 0, -12.4), (12, 4.6, -12), STONE)
    scene.box((-12.4, 0, -12.4), (-12, 3.2, 12), STONE)

    for k in range(6):
        scene.named(f"column {k}")
        x = -9 + 3.6 * k
        scene.box((x - 0.5, 0, -9.5), (x + 0.5, 0.3, -8.5), STONE)
        scene.turned((x, 0.3, -9), [(0.42, 0), (0.42, 0.1), (0.34, 0.2), (0.27, 3.0), (0.4, 3.2)], 20, STONE)
    scene.named("roof")
    scene.box((-9.8, 3.5, -9.6), (9.8, 3.9, -8.4), STONE)
    for k in range(25):
        x = -9.6 + 0.8 * k
        scene.box((x - 0.09, 3.9, -12), (x + 0.09, 4.1, -7.9), BARK)

    scene.named("fountain")
    scene.turned((0, 0, 0), [(2.6, 0), (2.6, 0.7), (2.3, 0.7), (2.3, 0.45)], 8, STONE)
    scene.turned((0, 0.4, 0), [(2.3, 0), (2.3, 0.06)], 8, WATER)
    scene.turned((0, 0.4, 0), [(0.5, 0), (0.25, 0.4), (0.2, 1.4), (1.1, 1.9), (1.15, 2.0), (0.3, 1.8), (0.15, 2.5)], 20, STONE)

    scene.named("stairs")
    for k in range(6):
        scene.box((-12, 0, 2 + 0.5 * k), (-9, 0.28 * (6 - k), 2.5 + 0.5 * k), STONE)

    scene.named("fence")
    for k in range(33):
        z = -7.5 + 0.5 * k
        scene.turned((9, 0, z), [(0.05, 0), (0.05, 1.7), (0, 2.0)], 6, IRON)
    scene.box((8.96, 0.3, -7.6), (9.04, 0.38, 8.6), IRON)
    scene.box((8.96, 1.5, -7.6), (9.04, 1.58, 8.6), IRON)

    for k, (x, z, size) in enumerate([(5.6, 4.2, 1.0), (-6.2, -3.4, 1.3), (5.2, -4.6, 0.8)]):
        scene.named(f"tree {k}")
        scene.turned((x, 0, z), [(0.2 * size, 0), (0.12 * size, 2 * size)], 10, BARK)
        for level in range(3):
            r, h = size * (1.2 - 0.3 * level), size * (1.3 + 0.75 * level)
            scene.turned((x, h, z), [(r, 0), (0.02, 1.3 * size)], 12, LEAF)
    return scene


with open("courtyard.obj", "w", encoding="ascii") as file:
    file.write("# Made by make_courtyard.py\n" + "\n".join(courtyard().lines) + "\n")
