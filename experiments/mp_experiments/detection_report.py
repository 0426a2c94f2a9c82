"""`run_experiments detection`: the table of the detection over random scenes, beside the thesis."""
from . import plots, thesis_numbers
from .detection_rows import ROWS, holds, measured, truncated_holds
from .errors import ExperimentError
from .page import Cell, Page, Row
from .report_parts import add_facts, add_commands
from .statistics import number

METHODS = (('best', 'ours'), ('thesis', "thesis' method"))
HEADERS = ['scenes', 'boxes', 'recall', 'precision', 'position mean', 'RMS', '95 %', 'worst', 'yaw mean', '95 %',
           'worst', 'sides RMS', '95 %', 'worst', 'height mean', 'worst', 'incomplete', 'within 2 σ', 'wrong sizes', 'ms']


def _across(text, kind=''):
    """A text over all columns but the first."""
    return Cell(text, kind, len(HEADERS) - 1)


def _title_row(title):
    return Row([Cell(title, '', len(HEADERS))], 'group title')


def _limit_row(row):
    if row.truncated:
        return ['wanted', _across('every one flagged TRUNCATED, no confident wrong size')]
    limits = row.limits
    return ['wanted', '', f'≥ {limits["recall"]:g}', f'≥ {limits["precision"]:g}',
            f'≤ {limits["position"]:g}', '', '', '', f'≤ {limits["yaw"]:g}', '', '', f'≤ {limits["side"]:g}', '', '',
            f'≤ {limits["height"]:g}', '', '', '', '', '']


def _judged(row, summary, limit, digits):
    text = number(measured(summary, limit), digits)
    if limit not in row.limits:
        return Cell(text)
    return Cell(text, 'good' if holds(row, summary, limit) else 'bad')


def _statistic(statistics, name, digits=2):
    return number(statistics[name] if statistics['count'] else None, digits)


def _figures(row, name, s):
    position, yaw, side, height = s['position_mm'], s['yaw_deg'], s['side_mm'], s['height_mm']
    cells = [name, s['boxes'], _judged(row, s, 'recall', 3), _judged(row, s, 'precision', 3),
             _judged(row, s, 'position', 2)]
    cells += [_statistic(position, which) for which in ('rms', 'p95', 'worst')]
    cells += [_judged(row, s, 'yaw', 3)] + [_statistic(yaw, which, 3) for which in ('p95', 'worst')]
    cells += [_judged(row, s, 'side', 2)] + [_statistic(side, which) for which in ('p95', 'worst')]
    cells += [_judged(row, s, 'height', 3), _statistic(height, 'worst'), s['incomplete'],
              number(s['coverage'] if position['count'] else None), s['sizes_beyond_stddev'],
              _statistic(s['detect_ms'], 'median', 0)]
    return cells


def _truncated_figures(name, s):
    text = (f'{s["truncated_flagged"]} flagged of {s["truncated_found"]} found of {s["truncated"]} in the scenes; '
            f'{s["sizes_beyond_stddev"]} wrong sizes; median {s["detect_ms"]["median"]:.0f} ms')
    return [name, _across(text, 'good' if truncated_holds(s) else 'bad')]


def _base_table(page, results):
    rows = []
    for row, measurements in results:
        s = measurements['best'].summary
        rows.append([row.title, f'{s["base_found"]} of {s["scenes"]}', number(s['base_origin_mm']['mean'], 3),
                     number(s['base_origin_mm']['worst'], 3), number(s['base_height_mm']['mean'], 3),
                     number(s['base_tilt_deg']['mean'], 4), number(s['base_yaw_deg']['mean'], 4),
                     number(s['base_yaw_deg']['worst'], 4), number(s['base_ms']['median'], 0)])
    page.heading('The base frame in these scenes')
    page.text('Found from the marker in every cloud; its errors are part of the errors of the boxes above.')
    page.table(['scenes', 'found', 'origin mean mm', 'worst mm', 'height mean mm', 'tilt mean °', 'yaw mean °',
                'worst °', 'median ms'], rows)


def _worst_scenes(page, measurer, results):
    page.heading('The worst scene of each row')
    page.text('Dashed green: true tops. Blue: found. Red: found where no box is. Missed and invented boxes count as worse '
              'than any error. Dark pixels carry no data.')
    pictures = []
    for row, measurements in results:
        best = measurements['best']
        index = best.summary['worst_scene']
        picture = plots.scene(measurer.picture(row.recipe, index), best.record(index))
        pictures.append((picture, f'{row.title}: scene {index}'))
    page.gallery(pictures)


def _chosen_rows(only):
    if not only:
        return ROWS
    unknown = set(only) - {row.recipe for row in ROWS}
    if unknown:
        raise ExperimentError(f'--only {sorted(unknown)[0]}: the rows are {", ".join(row.recipe for row in ROWS)}')
    return [row for row in ROWS if row.recipe in only]


def make(tools, measurer, options, out):
    count = options.count or (4 if options.quick else 50)
    results = []
    for row in _chosen_rows(options.only):
        tools.say(row.title)
        results.append((row, {method: measurer.measure(row.recipe, count, method) for method, _ in METHODS}))
    page = Page('Detection of boxes in simulated clouds')
    add_facts(page, [('scenes a row', count), ('seed', options.seed)])
    lines = []
    for row, measurements in results:
        lines += [_title_row(row.title), _limit_row(row)]
        for method, name in METHODS:
            s = measurements[method].summary
            lines.append(_truncated_figures(name, s) if row.truncated else _figures(row, name, s))
    lines += [_title_row('the thesis on its simulator (one to four separated boxes)'),
              ['printed', ''] + thesis_numbers.DETECTION_ROW]
    page.table(HEADERS, lines, 'Millimetres and degrees, base frame from the marker of each cloud. Position is '
               'the horizontal distance of the top\'s centre. "Incomplete": boxes of which a side is reported as not known; '
               'they are found, and left out of position and yaw. "Within 2 σ": share of the errors within two reported '
               'standard deviations. "Wrong sizes": beyond three standard deviations and 5 mm.', 'wide')
    page.text('Boxes count when their whole top lies in the image and at least 35 % of it is seen. '
              f'{thesis_numbers.DETECTION_SOURCE}')
    _base_table(page, results)
    _worst_scenes(page, measurer, results)
    add_commands(page, tools)
    path = out / 'detection.html'
    path.write_text(page.render(), encoding='utf-8')
    return path
