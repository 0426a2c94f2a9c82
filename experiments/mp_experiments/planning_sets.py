"""The planner on rich sets and real orders, beside what knows less and what knows more."""
import csv
import json
import pathlib

from .errors import ExperimentError
from .orders import unpacked_counts, utilizations
from .page import Cell, Row
from .statistics import mean, number, stddev

HEIGHT_MM = 800
BUDGET_MS, QUICK_BUDGET_MS = 1000.0, 5.0
PACK_S, QUICK_PACK_S = 10.0, 0.3
SHARE = 10  # of the orders of the report that a set has
SETS = (('blocks, turned about the vertical', 'yaw', ('--rotations', 'yaw')),
        ('blocks, turned any way', 'any', ('--rotations', 'any')),
        ('blocks, heights continuous', 'continuous', ('--continuous_heights',)),
        ('blocks, sides within 10 mm, about the vertical', 'spread', ('--size_spread_mm', 10, '--rotations', 'yaw')),
        ('the same, 5 mm gap, 75 % support', 'gap',
         ('--size_spread_mm', 10, '--rotations', 'yaw', '--gap_mm', 5, '--min_support_ratio', 0.75)),
        ('unlike boxes, about the vertical', 'cuts', ('--structure', 'cuts', '--rotations', 'yaw')))
METHODS, REAL_SETS = 5, 2
EUR_PALLET_M3 = 1.2 * 0.8 * 1.4
LEAST_PALLETS, MOST_PALLETS = 0.5, 1.5  # volume of the real orders that are played
REGRET_AIM = 3.0  # points of volume
WORSE_POINTS = 1e-6  # of volume, below which two packings are equally good


def first_orders(path, count, target):
    """Writes the first `count` orders of a CSV file whose boxes have about the volume of a pallet."""
    try:
        with open(path, newline='', encoding='utf-8') as file:
            rows = list(csv.DictReader(file))
        volumes = {}
        for row in rows:
            one = float(row['Length']) * float(row['Width']) * float(row['Height']) * 1e-9
            volumes[row['Order']] = volumes.get(row['Order'], 0.0) + one * int(row['Quantity'])
    except OSError as error:
        raise ExperimentError(f'{path}: {error.strerror}')
    except (KeyError, ValueError) as error:
        raise ExperimentError(f'{path}: is no file of orders: {error}')
    kept = [order for order, volume in volumes.items()
            if LEAST_PALLETS <= volume / EUR_PALLET_M3 <= MOST_PALLETS][:count]
    with open(target, 'w', newline='', encoding='utf-8') as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator='\n')
        writer.writeheader()
        writer.writerows(row for row in rows if row['Order'] in kept)
    return target


def _folder(data):
    """Of the published orders; None when there is none."""
    packing = pathlib.Path(data) / 'packing' if data else None
    return packing if packing and packing.is_dir() else None


def commands(data):
    """So many tools add() runs."""
    return len(SETS) + (len(SETS) + (REAL_SETS if _folder(data) else 0)) * 2 * METHODS


def _real(orders, folder, count):
    """(name, file) of the published orders."""
    packing = _folder(folder)
    if not packing:
        return []
    eur = first_orders(packing / 'orders_eur_pallet.csv', count, orders.folder / 'orders_eur_pallet.csv')
    bpp = orders.folder / 'bed_bpp_orders.json'
    content = json.loads((packing / 'bed_bpp_5_orders.json').read_text(encoding='utf-8'))
    bpp.write_text(json.dumps(dict(list(content.items())[:count])), encoding='utf-8')
    return [('real orders, EUR pallet of 1.4 m', orders.foreign(eur, ['--format', 'csv'])),
            ('BED-BPP, pallets and roll containers of 2 m', orders.foreign(bpp, ['--format', 'bed_bpp']))]


def result_row(label, results, heuristic, bound):
    """Volume, boxes left, regret to the bound, orders in which the heuristic used more volume."""
    used, base, most = utilizations(results), utilizations(heuristic), utilizations(bound)
    regret = [most[name] - used[name] for name in used]
    worse = sum(used[name] < base[name] - WORSE_POINTS for name in used)
    kind = 'good' if mean(regret) <= REGRET_AIM else ''
    return ['', label, f'{sum(c == 0 for c in unpacked_counts(results))} of {len(results)}',
            number(mean(list(used.values())), 2), number(stddev(list(used.values())), 2),
            number(mean(unpacked_counts(results)), 1), Cell(number(mean(regret), 2), kind), number(stddev(regret), 2),
            f'{worse} of {len(results)}']


def add(page, orders, count, data, quick):
    budget_ms, pack_s = (QUICK_BUDGET_MS, QUICK_PACK_S) if quick else (BUDGET_MS, PACK_S)
    few = max(1, count // SHARE)
    page.heading('Rich sets and real orders')
    page.text(f'{few} orders a set of {HEIGHT_MM} mm, seed {orders.seed}; {budget_ms:g} ms a decision, {pack_s:g} s for the order-free '
              'packer. The regret is the volume, in points, by which the order-free packer uses more: it sees all boxes at once and '
              'takes them in any sequence, so that a part of it is the price of seeing three. What knowing every arrival is worth '
              'tells the planner that knows the order: the weights of its policy are searched for that very order, as long as all '
              'decisions of `best` may last. Worse: orders in which less volume is used than by DBLF.')
    files = [(name, orders.generate(HEIGHT_MM, few, kind, more)) for name, kind, more in SETS]
    rows = []
    for name, path in files + _real(orders, data, few):
        heuristic = orders.plan(path, 'dblf', budget_ms)
        single = ['--max_pallets', 1]
        bound = orders.pack(path, 'best', pack_s, single)
        rows.append(Row([name] + [''] * 8, 'group'))
        for label, results in (('heuristic alone (DBLF)', heuristic), ("thesis' genetic search", orders.plan(path, 'ga', budget_ms)),
                               ('best', orders.plan(path, 'best', budget_ms, label='rich')),
                               ('knows the order of arrival', orders.plan(path, 'best', budget_ms, ['--knowledge', 'order'], 'known')),
                               ('order-free packer', bound)):
            rows.append(result_row(label, results, heuristic, bound))
    page.table(['set', '', 'all packed', 'volume used %', 's.d.', 'mean left', 'regret', 's.d.', 'worse'], rows)
    if not _folder(data):
        page.text('Real orders are left out: name the folder with packing by --data or MIXED_PALLETIZING_DATA.')
