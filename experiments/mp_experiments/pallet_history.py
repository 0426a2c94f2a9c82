"""The history of a pallet, as `pallet_journal --json` exports it, played again."""
from . import pallet_record


class _Play:
    """Follows the events: what was placed, what was thrown out and why, how long the decisions took."""

    def __init__(self, order):
        self.names = [item['type'] for item in order['items']]
        self.decisions, self.changes, self.decision_ms = {}, [], []

    def decided(self, event, _):
        self.decision_ms.append(event['decision_ms'])
        self.decisions[event['decision_id']] = event

    def reported(self, event, time):
        decision = self.decisions[event['decision_id']]
        if event['outcome'] == 'PLACED':
            planned = decision['options'][decision['chosen']]['placement']
            placed = event.get('measured', planned)
            self.changes.append(('placed', {
                'type': self.names[placed['type']], 'origin_mm': placed['origin_mm'], 'size_mm': placed['size_mm'],
                'decision_ms': decision['decision_ms'], 'available': len(decision['available']), 'time': time}))
        elif event['outcome'] == 'DISCARDED':
            self.changes.append(('discarded', self._discarded(event, decision)))

    def _discarded(self, event, decision):
        indices = event['discarded']
        if not indices:
            indices = [decision['chosen']] if 'chosen' in decision else range(len(decision['available']))
        options = decision['options']
        return [(self.names[decision['available'][i]], options[i].get('reason') or 'thrown out at the cell') for i in indices]

    def undone(self, _, __):
        self.changes.pop()

    def other(self, _, __):
        """Events that change neither the pallet nor the order."""


def from_journal(pallet):
    """Record of an exported pallet."""
    play = _Play(pallet['order'])
    for entry in pallet['history']:
        getattr(play, entry['kind'], play.other)(entry['event'], entry['time'])
    steps = [content for kind, content in play.changes if kind == 'placed']
    unpacked = [pair for kind, content in play.changes if kind == 'discarded' for pair in content]
    message = 'still open' if pallet['open'] else ''
    missing = 'still to come' if pallet['open'] else pallet_record.NEVER_CAME
    for name, count in zip(play.names, pallet['remaining']):
        unpacked += count * [(name, missing)]
    undone = sum(entry['kind'] == 'undone' for entry in pallet['history'])
    details = [('started', pallet['history'][0]['time']), ('last event', pallet['history'][-1]['time']),
               ('decisions', len(play.decision_ms)), ('reports taken back', undone)]
    return pallet_record.make(pallet['pallet_id'], 'journal', pallet['order']['pallet_mm'], pallet['order']['items'], steps,
                              unpacked, message, play.decision_ms, details)
