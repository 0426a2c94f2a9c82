"""Container loading instances of Bischoff and Ratcliff, beside what others publish on them."""
import pathlib

from .errors import ExperimentError
from .measurements import read_lines
from .page import Cell, Row
from .statistics import mean, number

SETS = tuple(f'BR{i}' for i in range(1, 8))
SECONDS = 10.0
# Volume utilization [%] of BR1 to BR7 with full support.
PUBLISHED = (('BRKGA (Goncalves, Resende 2012)', (94.34, 94.88, 95.05, 94.75, 94.58, 94.39, 93.74)),
             ('CLTRS (Fanslau, Bortfeldt 2010)', (94.51, 94.73, 94.74, 94.41, 94.13, 93.85, 93.20)))


def first_instances(path, count, target):
    """Writes the first `count` instances of a BR file; the numbers stand as in the file."""
    try:
        words = path.read_text(encoding='utf-8').split()
        total, at, kept = int(words[0]), 1, []
        for _ in range(min(total, count)):
            types = int(words[at + 5])
            end = at + 6 + 8 * types
            kept.append(' '.join(words[at:at + 2]) + '\n' + ' '.join(words[at + 2:at + 5]) + f'\n{types}\n')
            kept += [' '.join(words[i:i + 8]) + '\n' for i in range(at + 6, end, 8)]
            if end > len(words):
                raise ValueError('ends early')
            at = end
    except OSError as error:
        raise ExperimentError(f'{path}: {error.strerror}')
    except (ValueError, IndexError) as error:
        raise ExperimentError(f'{path}: is no BR file: {error}')
    target.write_text(f'{min(total, count)}\n' + ''.join(kept), encoding='utf-8')


def _utilization(orders, path, method, seconds):
    out = orders.folder / f'{path.stem}_{method}.jsonl'
    common = ['--format', 'br', '--method', method, '--time_limit_s', seconds, '--seed', orders.seed]
    orders.tools.run('pack', ['--instances', path, *common, '--out', out],
                     ['--instances', path.name, *common, '--out', out.name])
    orders.tools.run('check_packing', ['--instances', path, '--format', 'br', '--results', out],
                     ['--instances', path.name, '--format', 'br', '--results', out.name])
    return 100.0 * mean([result['utilization'] for result in read_lines(out)])


def add(page, orders, data, quick):
    page.heading('Published instances: Bischoff and Ratcliff, BR1 to BR7')
    folder = pathlib.Path(data) / 'packing' / 'br' if data else None
    if not folder or not folder.is_dir():
        page.text('Left out: name the folder with packing/br by --data or MIXED_PALLETIZING_DATA.')
        return
    sets, instances, seconds = (SETS[:1], 1, 1.0) if quick else (SETS, 5, SECONDS)
    figures = {'dblf': [], 'best': []}
    for name in sets:
        part = orders.folder / f'{name}_{instances}.txt'
        first_instances(folder / f'{name}.txt', instances, part)
        for method, values in figures.items():
            values.append(_utilization(orders, part, method, seconds))
    page.text(f'Volume used in percent with full support; the first {instances} instances of each set, {seconds:g} s each. Every '
              'packing passed check_packing. Published figures are means over 100 instances.')
    rows = [Row([name, *(number(v) for v in values[:len(sets)]), number(mean(values[:len(sets)]))])
            for name, values in PUBLISHED]
    for method, name in (('dblf', 'heuristic alone (DBLF)'), ('best', 'ours, best')):
        values = figures[method]
        rows.append(Row([name, *(number(v) for v in values), Cell(number(mean(values)))],
                        'group' if method == 'dblf' else ''))
    page.table(['', *sets, 'mean'], rows)
