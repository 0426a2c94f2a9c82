"""Sections on the stages: base frame, clusters, tops, edges (thesis 4.1.2, 4.1.3)."""
import statistics as builtin_statistics

from . import plots, thesis_numbers
from .page import Row
from .statistics import mean, number, quantile, stddev

THRESHOLDS_MM = (1, 2, 5, 10, 20)


def base_frame(page, measurer, counts):
    """4.1.2: orientation of the base frame"""
    printed = thesis_numbers.BASE_FRAME
    result = measurer.measure('thesis_orientation', counts['orientation'])
    found = [r for r in result.records if r['base']['found']]
    tilt = [r['base']['tilt_deg'] for r in found]
    yaw = [r['base']['yaw_deg'] for r in found]
    page.heading('Orientation of the base frame (Table 4.1)')
    page.text(f'{counts["orientation"]} views of the empty floor with the marker, 20 to 60 degrees from straight down. '
              'The thesis lost the marker in 7 of 50 views and prints errors about its y and k axes.')
    page.table(['', 'marker found', 'tilt mean °', 'tilt std °', 'about the normal, mean °', 'std °', 'worst °',
                'origin mean mm', 'worst mm'],
               [['printed', f'{printed["found"]} of {printed["views"]}', number(printed['tilt_mean']),
                 number(printed['tilt_std']), number(printed['yaw_mean'], 3), number(printed['yaw_std']), '–', '–', '–'],
                ['ours', f'{len(found)} of {len(result.records)}', number(mean(tilt), 4), number(stddev(tilt), 4),
                 number(mean(yaw), 4), number(stddev(yaw), 4), number(quantile(yaw, 1.0), 4),
                 number(result.summary['base_origin_mm']['mean'], 3),
                 number(result.summary['base_origin_mm']['worst'], 3)]])
    lost = [f'scene {r["scene"]}: {r["base"]["message"]}' for r in result.records if not r['base']['found']]
    if lost:
        page.code(lost)
    picture = plots.histograms([('about the normal', 'degrees', [('ours', yaw, plots.OURS)]),
                                ('tilt', 'degrees', [('ours', tilt, plots.OURS)])])
    if picture:
        page.figure(picture, 'Errors of the orientation.')


def clustering(page, measurer, counts):
    """4.1.3: clustering"""
    printed = thesis_numbers.CLUSTERING
    page.heading('Clustering (4.1.3, Fig. 4.4–4.7)')
    page.text('Clouds in which every box is found. The thesis counts on recordings and shows that its clusters fail on boxes '
              'that touch (Fig. 4.6) and on tops torn by a dark band (Fig. 4.7).')
    rows = [Row(['two boxes, apart or not', 'printed', f'{printed["all_found"]} of {printed["clouds"]}', '', ''])]
    pictures = []
    for name, title in (('separated', 'two boxes apart'), ('touching', 'two boxes in contact'),
                        ('torn', 'top torn by a dark band')):
        for i, (method, label) in enumerate((('thesis', "thesis' chain"), ('best', 'ours'))):
            result = measurer.measure(f'thesis_{name}', counts[name], method)
            complete = sum(all(b['found'] for b in r['boxes'] if b['truth']['counts']) for r in result.records)
            summary = result.summary
            rows.append(Row([title if i == 0 else '', label, f'{complete} of {summary["scenes"]}',
                             f'{summary["found"]} of {summary["boxes"]}', summary['invented']], '' if i else 'group'))
            index = result.records[0]['scene']
            picture = plots.scene(measurer.picture(f'thesis_{name}', index), result.record(index))
            pictures.append((picture, f'{title}, {label}: scene {index}'))
    page.table(['scenes', '', 'clouds with all boxes', 'boxes found', 'invented'], rows)
    page.text('Dashed green: true tops. Blue: found. Red: found where no box is. Dark pixels carry no data.')
    page.gallery(pictures)


def _variant(top, threshold):
    return next((v for v in top['variants'] if abs(v['threshold_mm'] - threshold) < 1e-6), None)


def _threshold_rows(tops):
    rows = []
    for threshold in (0, *THRESHOLDS_MM):
        variants = [(top, _variant(top, threshold)) for top in tops]
        variants = [(top, v) for top, v in variants if v]
        shares = [v['points'] / _variant(top, 0)['points'] for top, v in variants if _variant(top, 0)]
        complete = [v for _, v in variants if v['sizes']]
        errors = [e for _, v in variants if v['sizes']
                  for e in (v['sizes']['along_yaw']['length_mm'], v['sizes']['along_yaw']['width_mm'])]
        name = 'adaptive' if threshold == 0 else f'± {threshold} mm'
        rows.append([name, f'{len(complete)} of {len(tops)}', number(mean([v['depth_mm'] for _, v in variants]), 1),
                     number(mean(shares), 3), number(mean(errors)), number(quantile(errors, 0.95)),
                     number(quantile(errors, 1.0))])
    return rows


def tops(page, measurer, counts):
    """4.1.3: top-plane extraction"""
    page.heading('Extraction of the top (4.1.3, Fig. 4.8–4.10)')
    page.text('The thesis shows two faults of a constant threshold: side faces that pad the projection (Fig. 4.8) and tops that '
              'lose points (Fig. 4.9). Here both, by the errors of lengths and widths that follow; on even tops and on tops that '
              'bulge, sag and have dents. True base frame.')
    curves = []
    for recipe, title in (('thesis_size', 'even tops'), ('uneven', 'uneven tops')):
        found = measurer.tops(recipe, counts['tops'], THRESHOLDS_MM)
        page.table([title, 'edges on four sides', 'lower end below height mm', 'points (adaptive = 1)', 'sides: mean mm',
                    '95 % mm', 'worst mm'], _threshold_rows(found))
        for i, top in enumerate(found[:6]):
            reference = max(top['reference'], 1.0)
            curves.append((title if i == 0 else '', [-s[0] for s in top['slices']],
                           [max(s[1] / reference, 0.01) for s in top['slices']]))
    if curves:
        page.figure(plots.ratio_curves(curves, 2.0),
                    'Points of a slice of 1 mm over those of a slice through the sides, by its height, as in Fig. 4.10. Dashed: '
                    'the ratio 2 at which the adaptive separation ends.')


def edges(page, measurer, counts):
    """4.1.3 and 4.1.7: edges"""
    found = measurer.tops('thesis_size', counts['tops'], THRESHOLDS_MM)
    adaptive = [v for v in (_variant(top, 0) for top in found) if v]
    angles = [v['edge_angle_deg'] for v in adaptive if v['sides'] == 4]
    page.heading('Edges (4.1.3, 4.1.7)')
    page.text('Algorithm 2 on the convex hull of the top. The sizes of the thesis assume that opposite edges are parallel, and it '
              f'reports angles of up to {thesis_numbers.LARGEST_EDGE_ANGLE} degrees between them.')
    page.table(['', 'tops with four edges', 'angle of opposite edges, median °', '95 % °', 'worst °'],
               [['printed', '–', '–', '–', number(thesis_numbers.LARGEST_EDGE_ANGLE)],
                ["thesis' chain, measured here", f'{len(angles)} of {len(found)}',
                 number(builtin_statistics.median(angles) if angles else None, 3), number(quantile(angles, 0.95), 3),
                 number(quantile(angles, 1.0), 3)]])
