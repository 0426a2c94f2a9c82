#!/usr/bin/env python3
"""Writes the meshes of the example scenes and tests: an EUR pallet (EN 13698-1) and a bottle crate.

usage: make_meshes.py [ROOT]      (millimetres in config/meshes/eur_pallet.stl, metres in test/data/bottle_crate.ply)
"""
import pathlib
import sys

# Corners of a cuboid by bits x, y, z; faces counter-clockwise seen from outside.
FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def corners(low, high):
    return [tuple((high if corner >> axis & 1 else low)[axis] for axis in range(3)) for corner in range(8)]


def eur_pallet():
    """Cuboids (low, high) in mm; the origin in the middle of the underside."""
    cuboids = []
    widths, gap = (145, 100, 145, 100, 145), 41.25
    y = -400.0
    for width in widths:  # deck boards
        cuboids.append(((-600, y, 122), (600, y + width, 144)))
        y += width + gap
    for x in (-600, -72.5, 455):  # boards across
        cuboids.append(((x, -400, 100), (x + 145, 400, 122)))
    for x in (-600, -72.5, 455):  # blocks
        for y, width in ((-400, 100), (-72.5, 145), (300, 100)):
            cuboids.append(((x, y, 22), (x + 145, y + width, 100)))
    for y, width in ((-400, 100), (-72.5, 145), (300, 100)):  # runners
        cuboids.append(((-600, y, 0), (600, y + width, 22)))
    return cuboids


def bottle_crate(length=0.4, width=0.3, height=0.27, wall=0.01, columns=5, rows=4):
    """Cuboids (low, high) in m of an open crate with a compartment for every bottle."""
    x, y = length / 2, width / 2
    cuboids = [((-x, -y, 0.0), (x, y, wall)),
               ((-x, -y, wall), (-x + wall, y, height)), ((x - wall, -y, wall), (x, y, height)),
               ((-x + wall, -y, wall), (x - wall, -y + wall, height)),
               ((-x + wall, y - wall, wall), (x - wall, y, height))]
    thin, top = 0.003, 0.6 * height
    for i in range(1, columns):
        middle = -x + i * length / columns
        cuboids.append(((middle - thin, -y + wall, wall), (middle + thin, y - wall, top)))
    for i in range(1, rows):
        middle = -y + i * width / rows
        cuboids.append(((-x + wall, middle - thin, wall), (x - wall, middle + thin, top)))
    return cuboids


def write_stl(path, cuboids):
    lines = ['solid eur_pallet']
    for low, high in cuboids:
        points = corners(low, high)
        for a, b, c, d in FACES:
            for triangle in ((a, b, c), (a, c, d)):
                lines.append('facet normal 0 0 0\nouter loop')
                lines += ['vertex ' + ' '.join(f'{v:g}' for v in points[i]) for i in triangle]
                lines.append('endloop\nendfacet')
    path.write_text('\n'.join(lines + ['endsolid']) + '\n')


def write_ply(path, cuboids):
    vertices = [point for low, high in cuboids for point in corners(low, high)]
    faces = [[8 * i + corner for corner in face] for i in range(len(cuboids)) for face in FACES]
    header = ['ply', 'format ascii 1.0', f'element vertex {len(vertices)}', 'property float x', 'property float y',
              'property float z', f'element face {len(faces)}', 'property list uchar int vertex_indices', 'end_header']
    body = [' '.join(f'{v:.6g}' for v in vertex) for vertex in vertices]
    body += ['4 ' + ' '.join(map(str, face)) for face in faces]
    path.write_text('\n'.join(header + body) + '\n')


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent
    write_stl(root / 'config/meshes/eur_pallet.stl', eur_pallet())
    write_ply(root / 'test/data/bottle_crate.ply', bottle_crate())


if __name__ == '__main__':
    main()
