"""`run_experiments packing` and `run_experiments planning`: chapter 4.2 of the source thesis again."""
from . import packing_numbers, pallet_pictures, plots, published_packings
from .measurements import read_lines
from .orders import Orders, unpacked_counts
from .page import Page, Row
from .report_parts import add_commands, add_facts
from .statistics import mean, number

TIME_LIMIT_S = 1.0   # of a search, one order
BUDGET_MS = 100.0    # of one decision
QUICK_BUDGET_MS = 20.0

SEARCHES = (('ga', "thesis' genetic search"), ('best', 'best'))
PACKING_METHODS = (('distance', 'distance heuristic alone'), ('dblf', 'heuristic alone (DBLF)'), *SEARCHES)
PLANNING_METHODS = (('dblf', 'heuristic alone (DBLF)'), *SEARCHES)


def _summary_cells(results):
    counts = unpacked_counts(results)
    return [sum(c == 0 for c in counts), sum(c == 1 for c in counts), sum(c > 5 for c in counts), number(mean(counts)),
            max(counts), number(100.0 * mean([r['utilization'] for r in results]), 1)]


SUMMARY_HEADERS = ['all packed', 'one left', 'more than 5 left', 'mean left', 'most left', 'volume used %']


def _compared(results, heuristic):
    """Orders in which fewer, as many, and more boxes are left than by the heuristic."""
    pairs = list(zip(unpacked_counts(results), unpacked_counts(heuristic)))
    return [sum(a < b for a, b in pairs), sum(a == b for a, b in pairs), sum(a > b for a, b in pairs)]


def _gallery(page, orders_path, results, title):
    """The best and the worst packing of a file."""
    instances = {i['name']: i for i in read_lines(orders_path)}
    ordered = sorted(results, key=lambda r: (len(r['unpacked']), -r['utilization']))
    pictures = []
    for result, word in ((ordered[0], 'best'), (ordered[-1], 'worst')):
        picture = pallet_pictures.pallet(result['placements'], instances[result['name']]['pallet_mm'])
        pictures.append((picture, f'{title}, {word}: {result["name"]}, {len(result["unpacked"])} boxes left, '
                                  f'{100 * result["utilization"]:.1f} % of the volume'))
    page.gallery(pictures)


def _settings(options):
    return options.count or (3 if options.quick else packing_numbers.ORDERS)


def packing(tools, measurer, options, out):
    count = _settings(options)
    orders = Orders(tools, measurer.folder, options.seed)
    page = Page('Packing with the sequence free to choose')
    add_facts(page, [('orders a height', count), ('seed', options.seed), ('time limit', f'{TIME_LIMIT_S:g} s an order')])
    page.heading('Heuristic alone and searches (Fig. 4.22, 4.24)')
    page.text('Every order can be packed completely: it was cut from the full volume. Every packing passed check_packing, which '
              'shares no code with the packing. Printed figures are read from the histograms of the thesis.')
    rows, panels, shown = [], [], []
    for height in packing_numbers.HEIGHTS_MM:
        path = orders.generate(height, count)
        series = []
        left, perfect = packing_numbers.HEURISTIC_LEFT[height], packing_numbers.SEARCH_PERFECT[height]
        rows.append(Row([f'{height} mm', 'printed, heuristic alone', '', '', '', number(left), '', ''], 'group'))
        rows.append(['', 'printed, genetic search', f'{100 * perfect:.0f} %', '', '', '', '', ''])
        for i, (method, name) in enumerate(PACKING_METHODS):
            results = orders.pack(path, method, TIME_LIMIT_S)
            rows.append(['', f'{name}, of {count}', *_summary_cells(results)])
            series.append((name, unpacked_counts(results), plots.SERIES[i % len(plots.SERIES)]))
        panels.append((f'{height} mm', series))
        shown.append((path, results, f'{height} mm, {name}'))
    page.table(['height', '', *SUMMARY_HEADERS], rows)
    page.figure(plots.count_bars(panels, 'boxes left'), 'Orders by the boxes that are left, as in Fig. 4.22 and 4.24.')
    for path, results, title in shown:
        _gallery(page, path, results, title)
    published_packings.add(page, orders, options.data, options.quick)
    add_commands(page, tools)
    result = out / 'packing.html'
    result.write_text(page.render(), encoding='utf-8')
    return result


def _rules(page, orders, count, budget_ms):
    """Fig. 4.26: the placement rules of the thesis in its own planner."""
    page.heading('The placement rule (Fig. 4.26)')
    page.text(f'The thesis\' planner with either rule, orders of {packing_numbers.HEIGHTS_MM[0]} mm.')
    path = orders.generate(packing_numbers.HEIGHTS_MM[0], count)
    rows, series = [], []
    for (rule, printed), colour in zip(packing_numbers.PERFECT_BY_RULE.items(), (plots.THEIRS, plots.OURS)):
        results = orders.plan(path, 'ga', budget_ms, rule)
        rows.append(Row([rule, f'printed, of {packing_numbers.ORDERS}', printed, '', '', '', '', ''], 'group'))
        rows.append(['', f'measured, of {count}', *_summary_cells(results)])
        series.append((rule, unpacked_counts(results), colour))
    page.table(['rule', '', *SUMMARY_HEADERS], rows)
    page.figure(plots.count_bars([(f'{packing_numbers.HEIGHTS_MM[0]} mm', series)], 'boxes left'),
                'Orders by the boxes that are left, as in Fig. 4.26.')


def planning(tools, measurer, options, out):
    count = _settings(options)
    budget_ms = QUICK_BUDGET_MS if options.quick else BUDGET_MS
    orders = Orders(tools, measurer.folder, options.seed)
    page = Page('Picking from what has arrived')
    add_facts(page, [('orders a height', count), ('seed', options.seed), ('budget', f'{budget_ms:g} ms a decision')])
    page.heading('The next pick, step by step (Fig. 4.28, Table 4.8)')
    page.text('Three boxes are in view; after each pick the next arrives; when none of the three fits they are discarded. Better, '
              'equal and worse: orders with fewer, as many and more boxes left than the heuristic alone. The thesis\' figures are '
              f'of {packing_numbers.ORDERS} orders each, drawn by its own generator.')
    rows, panels, shown = [], [], []
    for height in packing_numbers.HEIGHTS_MM:
        path = orders.generate(height, count)
        printed = packing_numbers.ROBOTIC[height]
        left = packing_numbers.ROBOTIC_LEFT[height]
        rows.append(Row([f'{height} mm', f'printed, of {packing_numbers.ORDERS}', printed[0], '', '', number(left), '', '',
                         *printed[1:], ''], 'group'))
        series, heuristic = [], None
        for i, (method, name) in enumerate(PLANNING_METHODS):
            results = orders.plan(path, method, budget_ms)
            heuristic = heuristic or results
            rows.append(['', f'{name}, of {count}', *_summary_cells(results), *_compared(results, heuristic),
                         number(max(r['decision_ms']['max'] for r in results), 0)])
            series.append((name, unpacked_counts(results), plots.SERIES[i % len(plots.SERIES)]))
        panels.append((f'{height} mm', series))
        shown.append((path, results, f'{height} mm, {name}'))
    page.table(['height', '', *SUMMARY_HEADERS, 'better', 'equal', 'worse', 'longest decision ms'], rows)
    page.figure(plots.count_bars(panels, 'boxes left'), 'Orders by the boxes that are left, as in Fig. 4.28.')
    for path, results, title in shown:
        _gallery(page, path, results, title)
    _rules(page, orders, count, budget_ms)
    add_commands(page, tools)
    result = out / 'planning.html'
    result.write_text(page.render(), encoding='utf-8')
    return result
