"""Records of pallets as one HTML page that needs nothing else."""
import html

from . import pallet_drawings
from .page import Page

# Hides everything that was placed after the chosen pick.
SLIDER = """<p><label>picks <input type="range" min="0" max="{count}" value="{count}" oninput="showPicks(this)"> <output>{count}
</output> of {count}</label></p>
<script>
function showPicks(slider) {{
  slider.nextElementSibling.value = slider.value;
  slider.closest('section').querySelectorAll('[data-step]').forEach(function (part) {{
    part.style.visibility = Number(part.dataset.step) > Number(slider.value) ? 'hidden' : 'visible';
  }});
}}
</script>"""


def _millimetres(values):
    return '–' if values is None else pallet_drawings.millimetres(values)


def _percent(share):
    return f'{100.0 * share:.1f} %'


def _facts(record):
    total = sum(t['count'] for t in record['types'])
    center = record['center_of_gravity_mm']
    margin = record['gravity_margin_mm']
    rows = [['placed', f'{len(record["placements"])} of {total} boxes'],
            ['packing volume', _millimetres(record['pallet_mm']) + ' mm'],
            ['utilization', _percent(record['utilization'])], ['height', f'{record["height_mm"]:g} mm']]
    if center:
        rows.append(['centre of gravity', f'({center[0]:.0f}, {center[1]:.0f}, {center[2]:.0f}) mm, by {record["gravity_by"]}'])
    if margin is not None:
        rows.append(['centre of gravity inside the base by', f'{margin:.0f} mm'])
    times = record['decision_ms']
    if times:
        rows.append(['decision: median, 99th percentile, longest', f'{times["median"]:.1f}, {times["p99"]:.1f}, {times["max"]:.1f} ms'])
    return rows + record['details']


def _add_types(page, record):
    tint = pallet_drawings.colours(record)
    placed = {}
    for placement in record['placements']:
        placed[placement['type']] = placed.get(placement['type'], 0) + 1
    rows = ''.join(f'<tr><td><span class="tint" style="background:{tint[t["type"]]}"></span> {html.escape(t["type"])}</td>'
                   f'<td>{_millimetres(t["size_mm"])}</td><td>{placed.get(t["type"], 0)} of {t["count"]}</td></tr>'
                   for t in record['types'])
    page.raw(f'<table><thead><tr><th>type</th><th>size mm</th><th>placed</th></tr></thead><tbody>{rows}</tbody></table>')


def _add_unpacked(page, record):
    page.heading('Not on the pallet', 3)
    if not record['unpacked']:
        page.text('Nothing: every box of the order was placed.')
        return
    page.table(['type', 'boxes', 'reason'],
               [[u['type'] or 'not identified', u['count'], u['reason']] for u in record['unpacked']])


def _add_sequence(page, record):
    page.heading('Sequence', 3)
    known = [key for key in ('available', 'decision_ms', 'measured_mm', 'time')
             if any(p.get(key) is not None for p in record['placements'])]
    titles = {'available': 'chosen among', 'decision_ms': 'decision ms', 'measured_mm': 'measured mm', 'time': 'placed'}
    texts = {'available': str, 'decision_ms': lambda v: f'{v:.1f}', 'measured_mm': _millimetres, 'time': str}
    rows = [[p['sequence'], p['type'], _millimetres(p['origin_mm']).replace(' x ', ', '), _millimetres(p['size_mm']),
             _percent(p['utilization']), *('–' if p.get(key) is None else texts[key](p[key]) for key in known)]
            for p in record['placements']]
    page.table(['pick', 'type', 'corner mm', 'size as placed mm', 'utilization', *(titles[key] for key in known)], rows)


def _add(page, record):
    page.raw('<section>')
    if record['complete']:
        page.text('Complete: every box of the order was placed.')
    else:
        left = sum(u['count'] for u in record['unpacked'])
        page.text('Not complete: ' + (record['message'] or ('1 box is' if left == 1 else f'{left} boxes are')
                                      + ' not on the pallet') + '.')
    page.table([], _facts(record), kind='facts')
    _add_types(page, record)
    if record['placements']:
        page.heading('The pallet', 3)
        page.raw(SLIDER.format(count=len(record['placements'])))
        page.gallery([(pallet_drawings.in_space(record), 'Seen from above the corner at the origin, x to the right. The numbers '
                       'are the sequence; the red dot is the centre of gravity.'),
                      (pallet_drawings.in_space(record, turned=True), 'Seen from above the opposite corner.')])
        page.heading('Layer by layer', 3)
        page.text('From above, x to the right, y up. Coloured boxes stand at this height, grey ones reach through it, dashed ones '
                  'end there.')
        page.gallery([(pallet_drawings.layer(record, z), f'at {z:g} mm') for z in pallet_drawings.layer_heights(record)], 'layers')
    _add_unpacked(page, record)
    chart = pallet_drawings.decision_times(record)
    if chart:
        page.heading('Time of the decisions', 3)
        page.figure(chart)
    _add_sequence(page, record)
    page.raw('</section>')


def render(records):
    """The page of some records."""
    single = len(records) == 1
    page = Page(f'Pallet {records[0]["pallet_id"]}' if single else f'{len(records)} pallets')
    for record in records:
        if not single:
            page.heading(record['pallet_id'])
        _add(page, record)
    return page.render()
