"""Sections on what is measured of a box: height, position, yaw, size, time (thesis 4.1.4 to 4.1.8)."""
import math

from . import plots, thesis_numbers
from .page import Row
from .statistics import mean, number, quantile, rms, stddev
from .thesis_tables import METHODS, by_column, error_rows, printed_rows

COLOURS = {'thesis': plots.THEIRS, 'best': plots.OURS}
NAMES = {'thesis': "thesis' chain", 'best': 'ours'}


def _both(measurer, name, count):
    return {method: measurer.measure(name, count, method) for method, _ in METHODS}


def _panel(title, unit, results, values_of):
    return (title, unit, [(NAMES[m], values_of(results[m]), COLOURS[m]) for m, _ in METHODS])


def _figure(page, panels, caption):
    picture = plots.histograms(panels)
    if picture:
        page.figure(picture, caption)


def height(page, measurer, counts):
    """4.1.4: heights"""
    results = _both(measurer, 'thesis_size', counts['size'])
    page.heading('Height (Table 4.2, Fig. 4.12)')
    rows = printed_rows('printed, camera', [thesis_numbers.HEIGHT['Zivid']])
    rows += printed_rows('printed, simulator', [thesis_numbers.HEIGHT['simulator']])
    for method, name in METHODS:
        rows += error_rows([results[method].errors('height')], f'{name} ({len(results[method].boxes())} boxes)', 3)
    page.table(['', '', 'height mm'], rows)
    _figure(page, [_panel('height', 'mm', results, lambda r: r.errors('height'))], 'Errors of the height.')


def position(page, measurer, counts):
    """4.1.5: position"""
    results = _both(measurer, 'thesis_position', counts['position'])
    page.heading('Position in the base frame (Table 4.3, Fig. 4.15)')
    page.text('One box of one size and yaw, placed at random. Our y is the thesis\' -z: the sign of that column differs.')
    rows = printed_rows('printed', by_column(thesis_numbers.POSITION_BASE, 3))
    for method, name in METHODS:
        x, y = results[method].errors('x'), results[method].errors('y')
        rows += error_rows([x, y, [math.hypot(a, b) for a, b in zip(x, y)]],
                           f'{name} ({len(x)} boxes)', 3)
    page.table(['', '', "x mm", "y (thesis' z) mm", 'distance mm'], rows)
    _figure(page, [_panel('x', 'mm', results, lambda r: r.errors('x')), _panel('y', 'mm', results, lambda r: r.errors('y'))],
            'Errors of the position in the base frame.')
    page.heading('Position in the camera frame (Table 4.4, Fig. 4.16)')
    rows = printed_rows('printed', by_column(thesis_numbers.POSITION_CAMERA, 4))
    for method, name in METHODS:
        columns = [[b['camera_error_mm'][axis] for b in results[method].boxes() if b['complete']] for axis in range(3)]
        columns.append([math.sqrt(a * a + b * b + c * c) for a, b, c in zip(*columns)])
        rows += error_rows(columns, name, 3)
    page.table(['', '', 'x mm', 'y mm', 'z mm', 'distance mm'], rows)


def occlusion(page, measurer, counts):
    """4.1.5: the centroid against the lines under occlusion"""
    tops = measurer.tops('thesis_occlusion', counts['occlusion'], ())
    page.heading('Centre under occlusion: centroid against lines (Fig. 4.13)')
    page.text('A taller box hides 10 to 50 % of the top. The thesis shows one case; here all lower boxes of the scenes, by their '
              'hidden share. True base frame for centroid and lines of the thesis\' chain; ours with the marker\'s.')
    ours = measurer.measure('thesis_occlusion', counts['occlusion'], 'best')
    rows = [Row(['printed', 'one case', number(thesis_numbers.OCCLUSION['centroid'], 1),
                 number(thesis_numbers.OCCLUSION['lines'], 1), '–', '–', '–'])]
    for low, high in ((0.0, 0.02), (0.02, 0.2), (0.2, 0.35), (0.35, 0.65)):
        chosen = [t for t in tops if low <= 1.0 - t['truth']['visible_ratio'] < high]
        centroid = [t['variants'][0]['centroid_error_mm'] for t in chosen if t['variants']]
        lines = [t['variants'][0]['center_error_mm'] for t in chosen
                 if t['variants'] and t['variants'][0]['center_error_mm'] is not None]
        boxes = [b for b in ours.boxes() if low <= 1.0 - b['truth']['visible_ratio'] < high]
        best = [math.hypot(b['errors']['x'], b['errors']['y']) for b in boxes if b['complete']]
        rows.append(Row([f'{100 * low:.0f} to {100 * high:.0f} % hidden', len(chosen), number(mean(centroid), 1),
                         number(mean(lines), 1), f'{len(lines)} of {len(chosen)}', number(mean(best)),
                         f'{len(best)} of {len(boxes)}']))
    page.table(['', 'tops', 'centroid, mean mm', 'lines, mean mm', 'lines known', 'ours, mean mm', 'ours complete'], rows)
    if not tops:
        return
    worst = min(tops, key=lambda t: t['truth']['visible_ratio'])
    marks = [(*worst['centroid_px'], plots.WRONG), (*worst['truth']['center_px'], plots.FOUND)]
    picture = plots.scene(measurer.picture('thesis_occlusion', worst['scene']), ours.record(worst['scene']), marks)
    page.figure(picture, f'Scene {worst["scene"]}. Crosses as in Fig. 4.13: the centroid of the top\'s points (red), the true '
                'centre (blue). Outlines: true tops dashed green, ours blue.')


def orientation(page, measurer, counts):
    """4.1.6: yaw"""
    results = _both(measurer, 'thesis_yaw', counts['yaw'])
    page.heading('Orientation (Table 4.5, Fig. 4.17)')
    rows = printed_rows('printed', [thesis_numbers.YAW])
    rows = [Row(list(row) + ['–', '–', '–'], row.kind) for row in rows]
    for method, name in METHODS:
        boxes = [b for b in results[method].boxes() if b['complete']]
        turns = [[b['camera_turn_deg'][axis] for b in boxes] for axis in range(3)]
        rows += error_rows([[b['errors']['yaw'] for b in boxes]] + turns, f'{name} ({len(boxes)} boxes)', 4)
    page.table(['', '', 'yaw in the base frame °', 'about the camera\'s x °', 'y °', 'z °'], rows)
    _figure(page, [_panel('yaw', 'degrees', results, lambda r: r.errors('yaw'))], 'Errors of the yaw in the base frame.')


def size(page, measurer, counts):
    """4.1.7: sizes"""
    results = _both(measurer, 'thesis_size', counts['size'])
    tops = measurer.tops('thesis_size', counts['tops'], (1, 2, 5, 10, 20))
    page.heading('Size (Table 4.6, Fig. 4.18, eq. 3.11, 4.1–4.2)')
    page.text('The thesis measures width and length as the distance of two lines (eq. 3.11), proposes to measure along the yaw '
              'through the centre (eq. 4.1, 4.2), and to turn that line until width and length add up to the least. All three on '
              "the thesis' edges in the true base frame; then the whole chains with the marker's base frame.")
    rows = printed_rows('printed, camera', [thesis_numbers.SIZE['Zivid'][k] for k in ('width', 'length')])
    rows += printed_rows('printed, simulator', [thesis_numbers.SIZE['simulator'][k] for k in ('width', 'length')])
    for key, name in (('by_offsets', 'eq. 3.11'), ('along_yaw', 'eq. 4.1, 4.2'), ('smallest_sum', 'least sum over the angle')):
        sizes = [t['variants'][0]['sizes'][key] for t in tops if t['variants'] and t['variants'][0]['sizes']]
        rows += error_rows([[s['width_mm'] for s in sizes], [s['length_mm'] for s in sizes]], f'{name} ({len(sizes)} tops)', 3)
    for method, name in METHODS:
        result = results[method]
        rows += error_rows([result.errors('width'), result.errors('length')], f'{name} ({len(result.errors("width"))} boxes)', 3)
    page.table(['', '', 'width mm', 'length mm'], rows)
    _figure(page, [_panel('width', 'mm', results, lambda r: r.errors('width')),
                   _panel('length', 'mm', results, lambda r: r.errors('length'))], 'Errors of the sizes.')


def run_time(page, measurer, counts):
    """4.1.8: run time"""
    results = _both(measurer, 'thesis_size', counts['size'])
    page.heading('Run time (Table 4.7, Fig. 4.21)')
    page.text('Scenes of the size experiment, 1920 x 1200 points, one core: from the cloud to its boxes, the base frame being '
              'known. The thesis prints the time for one box on its own machine.')
    rows = [['printed, camera', *(number(v, 0) for v in thesis_numbers.RUN_TIME['Zivid']), '–', '–', '–'],
            ['printed, simulator', *(number(v, 0) for v in thesis_numbers.RUN_TIME['simulator']), '–', '–', '–']]
    series = []
    for method, name in METHODS:
        records = [r for r in results[method].records if r['base']['found'] and r['boxes']]
        one_box = [r['detect_ms'] / len(r['boxes']) for r in records]
        whole = [r['detect_ms'] for r in records]
        rows.append([name, number(mean(one_box), 1), number(stddev(one_box), 1), number(mean(whole), 1),
                     number(rms([w - mean(whole) for w in whole]), 1), number(quantile(whole, 1.0), 1)])
        series.append((NAMES[method], whole, COLOURS[method]))
    page.table(['', 'one box, mean ms', 'std ms', 'one cloud, mean ms', 'std ms', 'longest ms'], rows)
    _figure(page, [('one cloud', 'ms', series)], 'Times of one cloud.')
