"""Drawings of a packed pallet as SVG: in three dimensions and layer by layer. Elements that belong to a placement carry its
number in `data-step`, so that a page can show how the pallet grew."""
import html

COLOURS = ('#c19a6b', '#7fa8c9', '#9bbf85', '#d9b44a', '#b58db6', '#e08e79', '#8f9aa3', '#6fb3a8', '#c7c06f', '#a3a0d8')
INK, WOOD, GRAVITY = '#333', '#a5825a', '#c62828'
COS30 = 3 ** 0.5 / 2
CARRIER_MM = 100  # height of the carrier in the drawing
WIDTH_PX, LAYER_PX, CHART_PX = 520, 250, 900
LETTER_WIDTH = 0.6  # of a letter's height, about


def millimetres(values):
    """Sides or coordinates, to a tenth."""
    return ' x '.join(f'{round(v, 1):g}' for v in values)


def colours(record):
    """Colour of every type."""
    return {t['type']: COLOURS[i % len(COLOURS)] for i, t in enumerate(record['types'])}


def _shaded(colour, share):
    return '#' + ''.join(f'{int(int(colour[i:i + 2], 16) * share):02x}' for i in (1, 3, 5))


def _svg(view, width, parts):
    x, y, w, h = view
    return (f'<svg class="drawing" width="{width}" viewBox="{x:.0f} {y:.0f} {w:.0f} {h:.0f}" role="img">'
            + ''.join(parts) + '</svg>').encode()


def _polygon(points, fill, extra=''):
    text = ' '.join(f'{x:.1f},{y:.1f}' for x, y in points)
    return f'<polygon points="{text}" fill="{fill}" stroke="{INK}" stroke-width="3" stroke-linejoin="round"{extra}/>'


def _text(x, y, size, words, extra=''):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size:.0f}" text-anchor="middle"{extra}>{html.escape(str(words))}</text>'


def _flat(point):
    """Isometric: the viewer looks along (1, 1, -1), from the side of the origin."""
    x, y, z = point
    return (x - y) * COS30, -((x + y) / 2 + z)


def _overlap(a, b):
    """Whether two cuboids (low, high corner) share pixels: their ranges along x - y, x + z and y + z do."""
    for i, j, sign in ((0, 1, -1), (0, 2, 1), (1, 2, 1)):
        low = [c[0][i] + sign * (c[0][j] if sign > 0 else c[1][j]) for c in (a, b)]
        high = [c[1][i] + sign * (c[1][j] if sign > 0 else c[0][j]) for c in (a, b)]
        if high[0] <= low[1] or high[1] <= low[0]:
            return False
    return True


def _behind(a, b):
    """Whether cuboid a is seen behind b, when they share pixels."""
    return a[0][0] >= b[1][0] or a[0][1] >= b[1][1] or a[1][2] <= b[0][2]


def painting_order(cuboids):
    """Indices of disjoint cuboids (low, high corner), those behind first."""
    before = [[j for j, b in enumerate(cuboids) if j != i and _overlap(a, b) and _behind(b, a)] for i, a in enumerate(cuboids)]
    order, done = [], set()
    for start in range(len(cuboids)):
        stack = [start]
        while stack:
            i = stack[-1]
            waiting = [j for j in before[i] if j not in done and j not in stack]
            if i in done or not waiting:
                stack.pop()
                if i not in done:
                    done.add(i)
                    order.append(i)
            else:
                stack.append(waiting[0])
    return order


def _faces(low, high):
    """The three faces that are seen with their shade: top, the one at low y, the one at low x."""
    (x, y, z), (u, v, w) = low, high
    return ((((x, y, w), (u, y, w), (u, v, w), (x, v, w)), 1.0), (((x, y, z), (u, y, z), (u, y, w), (x, y, w)), 0.86),
            (((x, y, z), (x, v, z), (x, v, w), (x, y, w)), 0.72))


def _cuboid(low, high, colour):
    return ''.join(_polygon([_flat(p) for p in face], _shaded(colour, shade)) for face, shade in _faces(low, high))


def _corners(placement, pallet_mm, turned):
    """Low and high corner; `turned` by half a turn about the vertical."""
    low = list(placement['origin_mm'])
    high = [o + s for o, s in zip(low, placement['size_mm'])]
    if turned:
        low[:2], high[:2] = [pallet_mm[i] - high[i] for i in (0, 1)], [pallet_mm[i] - low[i] for i in (0, 1)]
    return tuple(low), tuple(high)


def _gravity(record, turned):
    center = record['center_of_gravity_mm']
    if center is None:
        return ''
    x, y, z = center if not turned else (record['pallet_mm'][0] - center[0], record['pallet_mm'][1] - center[1], center[2])
    (a, b), (c, d) = _flat((x, y, z)), _flat((x, y, 0))
    return (f'<line x1="{a:.0f}" y1="{b:.0f}" x2="{c:.0f}" y2="{d:.0f}" stroke="{GRAVITY}" stroke-width="6" '
            f'stroke-dasharray="18 12"/><circle cx="{a:.0f}" cy="{b:.0f}" r="20" fill="{GRAVITY}"/>')


def _volume(size):
    """The limits of the packing volume, dashed."""
    x, y, z = size
    lines = [((0, 0, z), (x, 0, z)), ((x, 0, z), (x, y, z)), ((x, y, z), (0, y, z)), ((0, y, z), (0, 0, z)),
             ((0, 0, 0), (0, 0, z)), ((x, 0, 0), (x, 0, z)), ((0, y, 0), (0, y, z))]
    ends = [(*_flat(a), *_flat(b)) for a, b in lines]
    return ''.join(f'<line x1="{a:.0f}" y1="{b:.0f}" x2="{c:.0f}" y2="{d:.0f}" stroke="#999" stroke-width="3" '
                   'stroke-dasharray="12 12"/>' for a, b, c, d in ends)


def in_space(record, turned=False):
    """The pallet seen from above the corner at its origin, or with `turned` from the opposite one; the red dot is the centre of
    gravity."""
    size, tint = record['pallet_mm'], colours(record)
    placements = record['placements']
    cuboids = [_corners(p, size, turned) for p in placements]
    letter = max(22.0, min(size[0], size[1]) / 18)
    parts = [_cuboid((0, 0, -CARRIER_MM), (size[0], size[1], 0), WOOD)]
    for i in painting_order(cuboids):
        low, high = cuboids[i]
        x, y = _flat(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]))
        parts.append(f'<g data-step="{placements[i]["sequence"]}">' + _cuboid(low, high, tint[placements[i]['type']])
                     + _text(x, y + letter / 3, letter, placements[i]['sequence']) + '</g>')
    parts += [_volume(size), _gravity(record, turned)]
    top = -((size[0] + size[1]) / 2 + size[2])
    view = (-size[1] * COS30 - 20, top - 20, (size[0] + size[1]) * COS30 + 40, CARRIER_MM - top + 40)
    return _svg(view, WIDTH_PX, parts)


def layer_heights(record):
    """Heights at which boxes stand, from the floor up."""
    return sorted({p['origin_mm'][2] for p in record['placements']})


def _rectangle(placement, depth, style):
    x, y = placement['origin_mm'][:2]
    w, h = placement['size_mm'][:2]
    return f'<rect x="{x}" y="{depth - y - h}" width="{w}" height="{h}" {style}/>'


def layer(record, height):
    """From above, x to the right and y up: the boxes that stand at this height in colour, those that reach through it grey, the
    tops they stand on dashed."""
    x_size, y_size = record['pallet_mm'][:2]
    tint = colours(record)
    parts = [f'<rect width="{x_size}" height="{y_size}" fill="#fbfaf7" stroke="{INK}" stroke-width="4"/>']
    standing = []
    for placement in record['placements']:
        base = placement['origin_mm'][2]
        top = base + placement['size_mm'][2]
        if base == height:
            standing.append(placement)
        elif base < height < top:
            parts.append(_rectangle(placement, y_size, 'fill="#d3d3d3" stroke="#aaa" stroke-width="3"'))
        elif top == height:
            parts.append(_rectangle(placement, y_size, 'fill="none" stroke="#888" stroke-width="3" stroke-dasharray="14 10"'))
    for placement in standing:
        (x, y, _), (w, h, _) = placement['origin_mm'], placement['size_mm']
        letter = max(18.0, min(h / 3, w / 5, 60))
        size = millimetres(placement['size_mm'])
        small = min(letter * 0.55, 0.9 * w / (LETTER_WIDTH * len(size)))
        parts.append(f'<g data-step="{placement["sequence"]}">'
                     + _rectangle(placement, y_size, f'fill="{tint[placement["type"]]}" stroke="{INK}" stroke-width="4"')
                     + _text(x + w / 2, y_size - y - h / 2 + letter / 6, letter, placement['sequence'], ' font-weight="600"')
                     + _text(x + w / 2, y_size - y - h / 2 + letter * 0.85, small, size) + '</g>')
    return _svg((-8, -8, x_size + 16, y_size + 16), LAYER_PX, parts)


def decision_times(record):
    """A bar for the time of every decision that placed a box; None when none is known."""
    values = [(p['sequence'], p.get('decision_ms')) for p in record['placements']]
    if not any(value is not None for _, value in values):
        return None
    most = max(value or 0.0 for _, value in values) or 1.0
    step = 880.0 / len(values)
    parts = ['<line x1="10" y1="140" x2="890" y2="140" stroke="#333"/>', _text(450, 172, 14, 'pick')]
    for number, value in values:
        tall = 115.0 * (value or 0.0) / most
        left = 10 + step * (number - 1)
        parts.append(f'<rect data-step="{number}" x="{left + step * 0.1:.1f}" y="{140 - tall:.1f}" width="{step * 0.8:.1f}" '
                     f'height="{tall:.1f}" fill="#2166ac"><title>pick {number}: {value or 0.0:.1f} ms</title></rect>')
    every = max(1, -(-len(values) // 30))
    parts += [_text(10 + step * (n - 0.5), 154, 11, n) for n, _ in values if n % every == 0 or n == 1]
    parts.append(f'<text x="10" y="14" font-size="14">{most:.0f} ms</text><line x1="10" y1="25" x2="890" y2="25" '
                 'stroke="#bbb" stroke-dasharray="4 4"/>')
    return _svg((0, 0, CHART_PX, 180), CHART_PX, parts)
