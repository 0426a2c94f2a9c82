"""Where the weight of a packed pallet is."""


def _hull(points):
    """Corners of the convex hull, counter-clockwise (Andrew's monotone chain)."""
    points = sorted(set(points))

    def chain(ordered):
        corners = []
        for p in ordered:
            while len(corners) > 1 and _turn(corners[-2], corners[-1], p) <= 0:
                corners.pop()
            corners.append(p)
        return corners[:-1]
    return chain(points) + chain(points[::-1])


def _turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _margin(point, corners):
    """Distance of a point from the nearest edge of a hull, negative outside."""
    distances = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        length = ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5
        distances.append(_turn(a, b, point) / length)
    return min(distances)


def _center(placement, axis):
    return placement['origin_mm'][axis] + placement['size_mm'][axis] / 2.0


def balance(placements, weight_kg):
    """Centre of gravity, by weight when the weight of every placed type is known (above 0) and by volume otherwise, and its
    distance in the plane from the edge of the hull of the boxes on the floor; both None for an empty pallet."""
    if not placements:
        return {'center_of_gravity_mm': None, 'gravity_by': None, 'gravity_margin_mm': None}
    known = all(weight_kg.get(p['type'], 0.0) > 0.0 for p in placements)
    masses = [weight_kg[p['type']] if known else p['size_mm'][0] * p['size_mm'][1] * p['size_mm'][2] for p in placements]
    total = sum(masses)
    center = [sum(m * _center(p, axis) for m, p in zip(masses, placements)) / total for axis in range(3)]
    floor = [(p['origin_mm'][0] + dx * p['size_mm'][0], p['origin_mm'][1] + dy * p['size_mm'][1])
             for p in placements if p['origin_mm'][2] == 0 for dx in (0, 1) for dy in (0, 1)]
    return {'center_of_gravity_mm': [round(c, 1) for c in center], 'gravity_by': 'weight' if known else 'volume',
            'gravity_margin_mm': round(_margin(center, _hull(floor)), 1) if floor else None}
