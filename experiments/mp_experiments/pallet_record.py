"""What became of a pallet, from whatever file tells it: the base of the reports.

A record is a dictionary of plain values, lengths in millimetres: see docs/pallet_report.md."""
from . import pallet_balance, statistics

NEVER_CAME = 'did not come before the pallet was closed'


def times(values):
    """Median, 99th percentile (nearest rank) and maximum [ms]; None when nothing was measured."""
    if not values:
        return None
    return {'count': len(values), 'median': statistics.quantile(values, 0.5), 'p99': statistics.quantile(values, 0.99),
            'max': max(values)}


def volume(size_mm):
    return size_mm[0] * size_mm[1] * size_mm[2]


def _counted(unpacked):
    """Equal types with equal reasons in one entry."""
    counts = {}
    for kind, reason in unpacked:
        counts[(kind, reason)] = counts.get((kind, reason), 0) + 1
    return [{'type': kind, 'reason': reason, 'count': count} for (kind, reason), count in counts.items()]


def make(pallet_id, source, pallet_mm, types, steps, unpacked, message='', decision_ms=(), details=None):
    """The record of one pallet.

    types: [{type, size_mm, count, weight_kg (0 = not known)}]; steps: placements in loading order, {type, origin_mm,
    size_mm} and optionally decision_ms, available, time, measured_mm; unpacked: pairs of type (None = not identified) and
    reason; details: pairs of name and value for people."""
    full = volume(pallet_mm)
    placements, used = [], 0.0
    for number, step in enumerate(steps, 1):
        used += volume(step['size_mm'])
        placements.append(dict(step, sequence=number, utilization=used / full))
    weights = {t['type']: t.get('weight_kg') or 0.0 for t in types}
    counted = _counted(unpacked)
    return {'pallet_id': pallet_id, 'source': source, 'pallet_mm': list(pallet_mm), 'complete': not counted and not message,
            'message': message, 'types': types, 'placements': placements, 'unpacked': counted, 'utilization': used / full,
            'height_mm': max((p['origin_mm'][2] + p['size_mm'][2] for p in placements), default=0),
            **pallet_balance.balance(placements, weights), 'decision_ms': times(list(decision_ms)),
            'details': [list(pair) for pair in details or ()]}
