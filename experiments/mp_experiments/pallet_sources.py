"""Files that tell what became of a pallet: a planner's journal, its export, the report of an executive, a result of
`pack` or `plan_picks`."""
import json
import pathlib
import tempfile

from . import pallet_record
from .errors import ExperimentError

SQLITE = b'SQLite format 3\0'
NAMES_SHOWN = 5


def _json(path, text):
    try:
        return json.loads(text)
    except ValueError as error:
        raise ExperimentError(f'{path}: is no JSON: {error}')


def _read(path):
    try:
        return pathlib.Path(path).read_bytes()
    except OSError as error:
        raise ExperimentError(f'{path}: cannot be read: {error.strerror}')


def _lines(path):
    text = _read(path).decode('utf-8', errors='replace')
    return [_json(f'{path}:{number}', line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]


def _named(path, entries, name):
    """The entry with this name, or the only one."""
    names = [entry['name'] for entry in entries]
    if not name and len(entries) == 1:
        return entries[0]
    if not name:
        more = ', ...' if len(names) > NAMES_SHOWN else ''
        raise ExperimentError(f'{path}: holds {len(names)}; choose one with --name: {", ".join(names[:NAMES_SHOWN])}{more}')
    if name not in names:
        raise ExperimentError(f'{path}: holds no {name!r}')
    return entries[names.index(name)]


def _items(instance):
    """Type of every item by its index."""
    if 'arrival' in instance:
        return instance['arrival']
    return [line['type'] for line in instance['items'] for _ in range(line['count'])]


def from_result(result, instance):
    """Records of a result, one for each of its pallets; an instance without arrival must not have been played (its items
    would have come in a sequence that only the seed knows)."""
    types = [{'type': t['type'], 'size_mm': t['size_mm'], 'count': t['count'], 'weight_kg': t.get('weight_kg', 0.0)}
             for t in instance['items']]
    played = any('available' in p for p in result['placements'])
    if played and 'arrival' not in instance and result['unpacked']:
        unpacked = [(None, 'fitted nowhere when it could be picked') for _ in result['unpacked']]
    else:
        items = _items(instance)
        reason = 'fitted nowhere when it could be picked' if played else 'found no place'
        unpacked = [(items[index], reason) for index in result['unpacked']]
    details = [(key, str(result[key])) for key in ('method', 'seed') if key in result]
    count = result.get('pallets', 1)
    records = []
    for number in range(count):
        steps = [dict(type=p['type'], origin_mm=p['origin_mm'], size_mm=p['size_mm'],
                      **({'available': len(p['available'])} if 'available' in p else {}))
                 for p in result['placements'] if p.get('pallet', 0) == number]
        name = result['name'] + (f', pallet {number + 1} of {count}' if count > 1 else '')
        left = unpacked if number + 1 == count else []
        records.append(pallet_record.make(name, 'result', instance['pallet_mm'], types, steps, left, details=details))
        records[-1]['decision_ms'] = result.get('decision_ms')
    return records


def from_executive(report):
    """Record of a report of cell_executive."""
    steps = [{key: pick[key] for key in ('type', 'origin_mm', 'size_mm', 'decision_ms', 'available', 'measured_mm')}
             for pick in report['picks']]
    unpacked = [(discard['type'], discard['reason']) for discard in report['discards']]
    missing = {item['type']: item['count'] for item in report['order']['items']}
    for entry in report['picks'] + report['discards']:
        if entry['type'] in missing:
            missing[entry['type']] -= 1
    unpacked += [(kind, pallet_record.NEVER_CAME) for kind, count in missing.items() for _ in range(max(count, 0))]
    details = [(f'{what} median, 99 %, longest', '{median:.0f}, {p99:.0f}, {max:.0f} ms'.format(**report['times_ms'][what]))
               for what in ('capture', 'detection')]
    return pallet_record.make(report['pallet_id'], 'executive', report['order']['pallet_mm'],
                              [dict(item, weight_kg=0.0) for item in report['order']['items']], steps, unpacked,
                              report['message'], [pick['decision_ms'] for pick in report['picks']], details)


def from_file(path, tools, pallet='', instances='', name=''):
    """Records of the pallets that a file tells of. Throws ExperimentError in one clear line."""
    from . import pallet_history
    data = _read(path)
    try:
        if data.startswith(SQLITE):
            with tempfile.TemporaryDirectory() as folder:
                export = pathlib.Path(folder) / 'pallet.json'
                tools.run('pallet_journal', ['--journal', path, '--json', export, *(['--pallet=' + pallet] if pallet else [])])
                return [pallet_history.from_journal(_json(path, export.read_text(encoding='utf-8')))]
        if instances:
            result = _named(path, _lines(path), name)
            return from_result(result, _named(instances, _lines(instances), result['name']))
        content = _json(path, data.decode('utf-8', errors='replace'))
        if 'history' in content:
            return [pallet_history.from_journal(content)]
        if 'picks' in content:
            return [from_executive(content)]
        if 'placements' in content:
            raise ExperimentError(f'{path}: is a result: name its orders with --instances')
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        raise ExperimentError(f'{path}: is broken: {type(error).__name__} {error}')
    raise ExperimentError(f'{path}: is no journal, no export of one, no report of an executive and no result')
