"""Container loading instances of Bischoff and Ratcliff, beside what others publish on them."""
import pathlib

from . import plots
from .errors import ExperimentError
from .measurements import read_lines
from .page import Cell, Row
from .statistics import mean, number

GROUPS = (tuple(f'BR{i}' for i in range(1, 8)), tuple(f'BR{i}' for i in range(8, 16)))
SECONDS = 10.0
CURVE_SECONDS = (0.3, 1.0, 3.0, 10.0)
CURVE_METHODS = (('ga', "thesis' genetic search", plots.THEIRS), ('brkga', 'random keys with rotations', plots.TRUTH),
                 ('best', 'best', plots.OURS))
# Volume utilization [%] of each set with full support, by group.
PUBLISHED = (('BRKGA (Goncalves, Resende 2012)', ((94.34, 94.88, 95.05, 94.75, 94.58, 94.39, 93.74),
                                                  (92.65, 91.90, 91.28, 90.39, 89.81, 89.27, 88.57, 87.96))),
             ('CLTRS (Fanslau, Bortfeldt 2010)', ((94.51, 94.73, 94.74, 94.41, 94.13, 93.85, 93.20),
                                                  (92.26, 91.48, 90.86, 90.11, 89.51, 88.98, 88.26, 87.57))))


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


class _Sets:
    """The first instances of the published sets, packed and checked."""

    def __init__(self, orders, folder):
        self.orders, self.folder = orders, folder

    def utilization(self, name, instances, method, seconds):
        """Mean volume used [%]."""
        part = self.orders.folder / f'{name}_{instances}.txt'
        if not part.exists():
            first_instances(self.folder / f'{name}.txt', instances, part)
        out = self.orders.folder / f'{part.stem}_{method}_{seconds:g}s.jsonl'
        common = ['--format', 'br', '--method', method, '--time_limit_s', seconds, '--seed', self.orders.seed]
        self.orders.tools.run('pack', ['--instances', part, *common, '--out', out],
                              ['--instances', part.name, *common, '--out', out.name])
        self.orders.tools.run('check_packing', ['--instances', part, '--format', 'br', '--results', out],
                              ['--instances', part.name, '--format', 'br', '--results', out.name])
        return 100.0 * mean([result['utilization'] for result in read_lines(out)])


def _table(page, sets, group, names, instances, seconds):
    rows = [Row([label, *(number(v) for v in values[group][:len(names)]), number(mean(values[group][:len(names)]))])
            for label, values in PUBLISHED]
    for method, label in (('dblf', 'heuristic alone (DBLF)'), ('best', 'ours, best')):
        values = [sets.utilization(name, instances, method, seconds) for name in names]
        rows.append(Row([label, *(number(v) for v in values), Cell(number(mean(values)))],
                        'group' if method == 'dblf' else ''))
    page.table(['', *names, 'mean'], rows)


def _curves(page, sets, names, limits):
    series = [(label, limits, [mean([sets.utilization(name, 1, method, seconds) for name in names]) for seconds in limits],
               colour) for method, label, colour in CURVE_METHODS]
    page.figure(plots.curves(series, 'seconds', 'volume used [%]'),
                f'Volume used over the time of a search: mean of the first instance of each of {", ".join(names)}.')


def add(page, orders, data, quick):
    page.heading('Published instances: Bischoff and Ratcliff, BR1 to BR15')
    folder = pathlib.Path(data) / 'packing' / 'br' if data else None
    if not folder or not folder.is_dir():
        page.text('Left out: name the folder with packing/br by --data or MIXED_PALLETIZING_DATA.')
        return
    groups = (GROUPS[0][:1],) if quick else GROUPS
    instances, seconds, limits = (1, 1.0, CURVE_SECONDS[:2]) if quick else (5, SECONDS, CURVE_SECONDS)
    sets = _Sets(orders, folder)
    page.text(f'Volume used in percent with full support; the first {instances} instances of each set, {seconds:g} s each. Every '
              'packing passed check_packing. Published figures are means over 100 instances.')
    for group, names in enumerate(groups):
        _table(page, sets, group, names, instances, seconds)
    _curves(page, sets, groups[0], limits)
