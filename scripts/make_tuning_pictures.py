#!/usr/bin/env python3
"""Draws the pictures of docs/tuning.md: one scene, detected with one threshold changed at a time.

usage: make_tuning_pictures.py [FOLDER]     (default: docs/; the package's setup.bash is sourced)
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import matplotlib
matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
WIDTH_PX, HEIGHT_PX, FOV_DEG = 1200, 750, 42.0
SCENE = f"""
floor: {{size_m: [3.0, 3.0], rgb: 0x6e6e6e}}
marker: {{dictionary: DICT_4X4_50, id: 0, side_m: 0.12}}
camera: {{width_px: {WIDTH_PX}, height_px: {HEIGHT_PX}, horizontal_fov_deg: {FOV_DEG}, eye_m: [0.0, -0.7, 1.35], target_m: [0.0, 0.05, 0.0]}}
boxes:
  - {{name: tall, size_m: [0.22, 0.16, 0.25], position_m: [-0.30, 0.14], yaw_deg: 15}}
  - {{name: flat, size_m: [0.20, 0.14, 0.014], position_m: [-0.28, -0.10], yaw_deg: -10, rgb: 0xd0c8b8}}
  - {{name: left, size_m: [0.16, 0.14, 0.10], position_m: [0.10, 0.24]}}
  - {{name: right, size_m: [0.16, 0.14, 0.10], position_m: [0.272, 0.24], rgb: 0xc19a6b}}
  - {{name: small, size_m: [0.05, 0.045, 0.05], position_m: [-0.05, -0.20], yaw_deg: 30, rgb: 0x9a7448}}
  - {{name: soft, size_m: [0.20, 0.14, 0.09], position_m: [0.20, -0.14], yaw_deg: 20, shape: {{bulge_m: 0.012, rounding_m: 0.01}}}}
noise: {{depth_stddev_at_1m_m: 0.0003, no_data_on_black: true}}
"""
# picture: panels of (key of detection, value); an empty key changes nothing
PICTURES = {
    'min_height': [('cluster.min_height_m', 0.008), ('', None), ('cluster.min_height_m', 0.06)],
    'max_height': [('', None), ('cluster.max_height_m', 0.2)],
    'min_side': [('', None), ('box.min_side_m', 0.06), ('box.min_side_m', 0.15)],
    'max_side': [('', None), ('box.max_side_m', 0.18)],
    'uneven': [('top.uneven_m', 0.001), ('', None), ('top.uneven_m', 0.02)],
    'touching': [('', None), ('box.touching_distance_m', 0.02)],
}
EDGES = ((0, 1), (1, 3), (3, 2), (2, 0), (4, 5), (5, 7), (7, 6), (6, 4), (0, 4), (1, 5), (2, 6), (3, 7))
GOOD, FLAGGED, REFUSED = '#2ca02c', '#e6b800', '#d62728'


def run(tool, *arguments):
    subprocess.run(['rosrun', 'mixed_palletizing', tool, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def parameters(key, value):
    """A parameter file with one threshold of `detection` changed."""
    if not key:
        return '{}\n'
    group, name = key.split('.')
    return f'detection: {{{group}: {{{name}: {value}}}}}\n'


def detect(folder, key, value):
    (folder / 'p.yaml').write_text(parameters(key, value), encoding='utf-8')
    run('detect_boxes', '--cloud', folder / 'c.pcd', '--params', folder / 'p.yaml', '--json', folder / 'd.json')
    return json.loads((folder / 'd.json').read_text(encoding='utf-8'))


def pixel(base_from_camera, point):
    """Column and row of a point of the base frame."""
    moved = [p - base_from_camera[i][3] for i, p in enumerate(point)]
    x, y, z = (sum(base_from_camera[row][axis] * moved[row] for row in range(3)) for axis in range(3))
    focal = WIDTH_PX / 2 / math.tan(math.radians(FOV_DEG) / 2)
    return focal * x / z + (WIDTH_PX - 1) / 2, focal * y / z + (HEIGHT_PX - 1) / 2


def solid(axis, found, center, size, yaw, colour):
    corners = []
    for index in range(8):
        a, b, c = (size[i] * (0.5 if index >> i & 1 else -0.5) for i in range(3))
        corners.append(pixel(found['base_from_camera'], [center[0] + a * math.cos(yaw) - b * math.sin(yaw),
                                                         center[1] + a * math.sin(yaw) + b * math.cos(yaw), center[2] + c]))
    for start, end in EDGES:
        axis.plot(*zip(corners[start], corners[end]), color=colour, linewidth=1.6)
    return max(c[0] for c in corners), min(c[1] for c in corners)


def words(axis, place, text, colour):
    axis.text(place[0], max(place[1] - 8, 40), text, color='white', fontsize=7, ha='right', va='bottom',
              bbox={'facecolor': colour, 'edgecolor': 'none', 'pad': 1.5, 'alpha': 0.85})


def panel(axis, image, found, title):
    axis.imshow(image)
    for box in found['boxes']:
        colour = FLAGGED if box['flags'] else GOOD
        place = solid(axis, found, box['center'], box['size'], box['yaw'], colour)
        words(axis, place, ' '.join(f'{1000 * s:.0f}' for s in box['size']) + ''.join('\n' + f for f in box['flags']), colour)
    for cluster in found['rejected']:
        place = solid(axis, found, cluster['centroid'], cluster['extent'], 0.0, REFUSED)
        words(axis, place, cluster['text'].replace(', ', ',\n'), REFUSED)
    axis.set_title(title, fontsize=9)
    axis.set_xlim(0, WIDTH_PX - 1)
    axis.set_ylim(HEIGHT_PX - 1, 0)
    axis.axis('off')


def main():
    out = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / 'docs'
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / 's.yaml').write_text(SCENE, encoding='utf-8')
        run('simulate_scene', '--scene', folder / 's.yaml', '--out', folder / 'c.pcd', '--truth', folder / 't.json', '--color',
            folder / 'c.png')
        image = pyplot.imread(str(folder / 'c.png'))
        for name, panels in PICTURES.items():
            figure, axes = pyplot.subplots(1, len(panels), figsize=(4.2 * len(panels), 2.9))
            for axis, (key, value) in zip(axes, panels):
                panel(axis, image, detect(folder, key, value), f'{key}: {value}' if key else 'default')
            figure.tight_layout()
            figure.savefig(str(out / f'tuning_{name}.jpg'), dpi=90)
            pyplot.close(figure)
            print(out / f'tuning_{name}.jpg')


if __name__ == '__main__':
    main()
