"""`run_experiments packing`: orders packed in a free sequence, chapter 4.2 of the source thesis again."""
from . import packing_numbers, pallet_pictures, plots, published_packings
from .measurements import read_lines
from .orders import Orders, unpacked_counts
from .page import Page, Row
from .report_parts import add_commands, add_facts
from .statistics import mean, number

TIME_LIMIT_S = 1.0   # of a search, one order

SEARCHES = (('ga', "thesis' genetic search"), ('best', 'best'))
PACKING_METHODS = (('distance', 'distance heuristic alone'), ('dblf', 'heuristic alone (DBLF)'), *SEARCHES)


def summary_cells(results):
    counts = unpacked_counts(results)
    return [sum(c == 0 for c in counts), sum(c == 1 for c in counts), sum(c > 5 for c in counts), number(mean(counts)),
            max(counts), number(100.0 * mean([r['utilization'] for r in results]), 1)]


SUMMARY_HEADERS = ['all packed', 'one left', 'more than 5 left', 'mean left', 'most left', 'volume used %']


def gallery(page, orders_path, results, title):
    """The best and the worst packing of a file."""
    instances = {i['name']: i for i in read_lines(orders_path)}
    ordered = sorted(results, key=lambda r: (len(r['unpacked']), -r['utilization']))
    pictures = []
    for result, word in ((ordered[0], 'best'), (ordered[-1], 'worst')):
        picture = pallet_pictures.pallet(result['placements'], instances[result['name']]['pallet_mm'])
        pictures.append((picture, f'{title}, {word}: {result["name"]}, {len(result["unpacked"])} boxes left, '
                                  f'{100 * result["utilization"]:.1f} % of the volume'))
    page.gallery(pictures)


def orders_of(options):
    return options.count or (3 if options.quick else packing_numbers.ORDERS)


def packing(tools, measurer, options, out):
    count = orders_of(options)
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
            rows.append(['', f'{name}, of {count}', *summary_cells(results)])
            series.append((name, unpacked_counts(results), plots.SERIES[i % len(plots.SERIES)]))
        panels.append((f'{height} mm', series))
        shown.append((path, results, f'{height} mm, {name}'))
    page.table(['height', '', *SUMMARY_HEADERS], rows)
    page.figure(plots.count_bars(panels, 'boxes left'), 'Orders by the boxes that are left, as in Fig. 4.22 and 4.24.')
    for path, results, title in shown:
        gallery(page, path, results, title)
    published_packings.add(page, orders, options.data, options.quick)
    add_commands(page, tools)
    result = out / 'packing.html'
    result.write_text(page.render(), encoding='utf-8')
    return result
