"""Packed pallets drawn as boxes in three dimensions."""
from . import plots

COLOURS = ('#c19a6b', '#7fa8c9', '#9bbf85', '#d9b44a', '#b58db6', '#e08e79', '#8f9aa3', '#6fb3a8', '#c7c06f')
# Faces of a unit cube by their corners.
FACES = (((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
         ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)), ((0, 1, 0), (1, 1, 0), (1, 1, 1), (0, 1, 1)),
         ((0, 0, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1)), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)))


def _faces(placement):
    origin, size = placement['origin_mm'], placement['size_mm']
    return [[tuple(o + s * c for o, s, c in zip(origin, size, corner)) for corner in face] for face in FACES]


def growing(placements, pallet_mm, pictures=6):
    """Pairs (number of picks, picture) of a pallet at even steps; placements in loading order."""
    steps = sorted({max(1, round(len(placements) * (i + 1) / pictures)) for i in range(pictures)})
    types = _types(placements)
    return [(picks, pallet(placements[:picks], pallet_mm, types)) for picks in steps if picks <= len(placements)]


def _types(placements):
    return sorted({p['type'] for p in placements})


def pallet(placements, pallet_mm, types=None):
    """The boxes of one pallet, a colour for each of the types."""
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    figure = plots.pyplot.figure(figsize=(5.2, 4.6))
    axis = figure.add_subplot(111, projection='3d')
    types = types or _types(placements)
    faces, colours = [], []
    for placement in placements:
        faces += _faces(placement)
        colours += len(FACES) * [COLOURS[types.index(placement['type']) % len(COLOURS)]]
    # One collection: faces are sorted by depth within a collection only.
    axis.add_collection3d(Poly3DCollection(faces, facecolors=colours, edgecolors='#333', linewidths=0.5))
    axis.set_xlim(0, pallet_mm[0])
    axis.set_ylim(0, pallet_mm[1])
    axis.set_zlim(0, pallet_mm[2])
    try:
        axis.set_box_aspect(pallet_mm)
    except AttributeError:  # matplotlib before 3.3 draws a cube
        pass
    axis.set_xlabel('x mm', fontsize=8)
    axis.set_ylabel('y mm', fontsize=8)
    axis.tick_params(labelsize=7)
    axis.view_init(elev=24, azim=-55)
    return plots.as_bytes(figure)
