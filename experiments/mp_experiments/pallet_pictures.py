"""Packed pallets of results, drawn as those of the reports of pallets."""
from . import pallet_drawings


def growing(placements, pallet_mm, pictures=6):
    """Pairs (number of picks, picture) of a pallet at even steps; placements in loading order."""
    steps = sorted({max(1, round(len(placements) * (i + 1) / pictures)) for i in range(pictures)})
    types = _types(placements)
    return [(picks, pallet(placements[:picks], pallet_mm, types)) for picks in steps if picks <= len(placements)]


def _types(placements):
    return sorted({p['type'] for p in placements})


def pallet(placements, pallet_mm, types=None):
    """The boxes of one pallet with their loading order, a colour for each of the types; SVG."""
    numbered = [dict(placement, sequence=i) for i, placement in enumerate(placements, 1)]
    return pallet_drawings.in_space({'pallet_mm': pallet_mm, 'placements': numbered, 'center_of_gravity_mm': None,
                                     'types': [{'type': name} for name in types or _types(placements)]})
