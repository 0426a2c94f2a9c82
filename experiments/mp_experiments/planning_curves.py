"""How the planner gains by more boxes in view and by more time."""
import json

from . import plots
from .measurements import read_lines
from .statistics import mean, number, stddev

HEIGHT_MM = 800
# Name of a kind of orders, arguments of its generator, colour.
KINDS = (('columns', ('--structure', 'columns'), plots.OURS),
         ('continuous', ('--continuous_heights',), plots.TRUTH),
         ('spread', ('--size_spread_mm', 10, '--rotations', 'yaw'), plots.THEIRS))
N_PICK = (1, 2, 3, 5, 10)
BUDGETS_MS = (1.0, 10.0, 100.0, 1000.0, 10000.0)
QUICK_BUDGETS_MS = (1.0, 2.0, 5.0)
SHARE = 20  # of the orders of the report that a point of a curve is played with


def _with_n_pick(path, n_pick):
    """A copy of a file of orders with so many boxes in view."""
    copy = path.with_name(f'{path.stem}_pick{n_pick}.jsonl')
    copy.write_text(''.join(json.dumps(dict(order, n_pick=n_pick)) + '\n' for order in read_lines(path)), encoding='utf-8')
    return copy


def _cells(results):
    used = [100.0 * result['utilization'] for result in results]
    return [f'{sum(not r["unpacked"] for r in results)} of {len(results)}', f'{mean(used):.2f}', number(stddev(used), 2)]


def _curve(page, files, points, header, run):
    """`run(path, point)` gives results; a table, and curves for the figure."""
    rows, curves = [], []
    for name, path, colour in files:
        values = []
        for point in points:
            results = run(path, point)
            values.append(mean([100.0 * result['utilization'] for result in results]))
            rows.append([name, f'{point:g}', *_cells(results)])
        curves.append((name, points, values, colour))
    page.table(['orders', header, 'all packed', 'volume used %', 'spread (s.d.)'], rows)
    return curves


def _budgets(quick):
    return QUICK_BUDGETS_MS if quick else BUDGETS_MS


def commands(quick):
    """So many tools add() runs."""
    return len(KINDS) * (1 + 2 * (len(N_PICK) + len(_budgets(quick))))


def add(page, orders, count, budget_ms, quick):
    few = max(1, count // SHARE)
    files = [(name, orders.generate(HEIGHT_MM, few, name, more), colour) for name, more, colour in KINDS]
    page.heading('Boxes in view')
    page.text(f'Method best, {budget_ms:g} ms a decision, orders of {HEIGHT_MM} mm, {few} a point; seed {orders.seed}.')
    curves = _curve(page, files, N_PICK, 'boxes in view',
                    lambda path, n: orders.plan(_with_n_pick(path, n), 'best', budget_ms))
    page.figure(plots.curves(curves, 'boxes in view', 'volume used [%]'), 'Volume used over the number of boxes in view.')
    page.heading('Time to decide')
    page.text(f'Method best, three boxes in view, orders of {HEIGHT_MM} mm, {few} a point; seed {orders.seed}. The planner ends a decision '
              'early when it is certain.')
    curves = _curve(page, files, _budgets(quick), 'budget ms',
                    lambda path, budget: orders.plan(path, 'best', budget, label=f'{budget:g}ms'))
    page.figure(plots.curves(curves, 'budget of a decision [ms]', 'volume used [%]'),
                'Volume used over the time allowed for a decision.')
