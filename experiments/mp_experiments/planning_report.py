"""`run_experiments planning`: boxes packed as they arrive, chapter 4.2 of the source thesis again and our own questions."""
from . import packing_numbers, pallet_pictures, planning_curves, planning_sets, plots
from .errors import ExperimentError
from .measurements import read_lines
from .order_reports import SEARCHES, SUMMARY_HEADERS, orders_of, summary_cells
from .orders import Orders, unpacked_counts
from .page import Page, Row
from .report_parts import add_commands, add_facts
from .statistics import number

BUDGET_MS = 100.0    # of one decision
QUICK_BUDGET_MS = 5.0
METHODS = (('dblf', 'heuristic alone (DBLF)'), *SEARCHES)
STRUCTURES = ('blocks', 'columns')


def _compared(results, heuristic):
    """Orders in which fewer, as many, and more boxes are left than by the heuristic."""
    pairs = list(zip(unpacked_counts(results), unpacked_counts(heuristic)))
    return [sum(a < b for a, b in pairs), sum(a == b for a, b in pairs), sum(a > b for a, b in pairs)]


def _structure(page, orders, structure, count, budget_ms):
    """Fig. 4.28 and Table 4.8 with orders of one structure; the results of `best` by height."""
    rows, panels, shown = [], [], {}
    for height in packing_numbers.HEIGHTS_MM:
        path = orders.generate(height, count, structure, ['--structure', structure])
        printed = packing_numbers.ROBOTIC[height]
        rows.append(Row([f'{height} mm', f'printed, of {packing_numbers.ORDERS}', printed[0], '', '',
                         number(packing_numbers.ROBOTIC_LEFT[height]), '', '', *printed[1:], ''], 'group'))
        series, heuristic = [], None
        for i, (method, name) in enumerate(METHODS):
            results = orders.plan(path, method, budget_ms)
            heuristic = heuristic or results
            rows.append(['', f'{name}, of {count}', *summary_cells(results), *_compared(results, heuristic),
                         number(max(r['decision_ms']['max'] for r in results), 0)])
            series.append((name, unpacked_counts(results), plots.SERIES[i % len(plots.SERIES)]))
        panels.append((f'{height} mm', series))
        shown[height] = (path, results)
    page.table(['height', '', *SUMMARY_HEADERS, 'better', 'equal', 'worse', 'longest decision ms'], rows,
               f'Structure of the orders: {structure}.')
    page.figure(plots.count_bars(panels, 'boxes left'), f'Orders ({structure}) by the boxes that are left, as in Fig. 4.28.')
    return shown


def _growing(page, path, results):
    """A pallet pick by pick."""
    page.heading('A pallet grows')
    result = max(results, key=lambda r: len(r['placements']))
    instance = next(i for i in read_lines(path) if i['name'] == result['name'])
    page.gallery([(picture, f'after {picks} of {len(result["placements"])} picks') for picks, picture
                  in pallet_pictures.growing(result['placements'], instance['pallet_mm'])])
    page.text(f'{result["name"]}: {len(result["unpacked"])} boxes left, {100 * result["utilization"]:.1f} % of the volume.')


def _rules(page, orders, count, budget_ms):
    """Fig. 4.26: the placement rules of the thesis in its own planner."""
    height = packing_numbers.HEIGHTS_MM[0]
    page.heading('The placement rule (Fig. 4.26)')
    page.text(f'The thesis\' planner with either rule, orders of {height} mm.')
    path = orders.generate(height, count)
    rows, series = [], []
    for (rule, printed), colour in zip(packing_numbers.PERFECT_BY_RULE.items(), (plots.THEIRS, plots.OURS)):
        results = orders.plan(path, 'ga', budget_ms, ['--rule', rule], rule)
        rows.append(Row([rule, f'printed, of {packing_numbers.ORDERS}', printed, '', '', '', '', ''], 'group'))
        rows.append(['', f'measured, of {count}', *summary_cells(results)])
        series.append((rule, unpacked_counts(results), colour))
    page.table(['rule', '', *SUMMARY_HEADERS], rows)
    page.figure(plots.count_bars([(f'{height} mm', series)], 'boxes left'),
                'Orders by the boxes that are left, as in Fig. 4.26.')


def _steps(page, orders, count, options, budget_ms):
    """Fig. 4.28 and Table 4.8, and a pallet that grows."""
    page.heading('The next pick, step by step (Fig. 4.28, Table 4.8)')
    page.text('Three boxes are in view; after each pick the next arrives; when none of the three fits they are discarded. Better, '
              'equal and worse: orders with fewer, as many and more boxes left than the heuristic alone. The thesis\' figures are '
              f'of {packing_numbers.ORDERS} orders each, drawn by its own generator.')
    shown = [_structure(page, orders, structure, count, budget_ms) for structure in STRUCTURES]
    _growing(page, *shown[0][packing_numbers.HEIGHTS_MM[0]])


# Name of a part of the report: how many tools it runs, what makes it.
PARTS = {
    'steps': (lambda options: len(STRUCTURES) * len(packing_numbers.HEIGHTS_MM) * (1 + 2 * len(METHODS)), _steps),
    'rules': (lambda options: 1 + 2 * len(packing_numbers.PERFECT_BY_RULE),
              lambda page, orders, count, options, budget_ms: _rules(page, orders, count, budget_ms)),
    'curves': (lambda options: planning_curves.commands(options.quick),
               lambda page, orders, count, options, budget_ms:
               planning_curves.add(page, orders, count, budget_ms, options.quick)),
    'rich': (lambda options: planning_sets.commands(options.data),
             lambda page, orders, count, options, budget_ms:
             planning_sets.add(page, orders, count, options.data, options.quick)),
}


def planning(tools, measurer, options, out):
    unknown = [name for name in options.only or () if name not in PARTS]
    if unknown:
        raise ExperimentError(f'--only {unknown[0]}: planning has {", ".join(PARTS)}')
    parts = [part for name, part in PARTS.items() if not options.only or name in options.only]
    count = orders_of(options)
    budget_ms = QUICK_BUDGET_MS if options.quick else BUDGET_MS
    orders = Orders(tools, measurer.folder, options.seed, options.threads)
    page = Page('Picking from what has arrived')
    add_facts(page, [('orders a height', count), ('seed', options.seed), ('budget', f'{budget_ms:g} ms a decision'),
                     ('orders side by side', options.threads)])
    tools.expected = sum(commands(options) for commands, _ in parts)
    for _, add in parts:
        add(page, orders, count, options, budget_ms)
    add_commands(page, tools)
    result = out / 'planning.html'
    result.write_text(page.render(), encoding='utf-8')
    return result
