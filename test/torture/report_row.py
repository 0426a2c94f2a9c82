"""The last line of a torture test, from which scripts/torture.sh makes its table."""
import json


def print_row(test, tried, survived, lost, p99_s=None, slowest_s=None):
    """Times [s] are those of the recovery; None where nothing has to recover."""
    print('ROW ' + json.dumps({'test': test, 'tried': tried, 'survived': survived, 'lost': lost, 'p99_s': p99_s,
                               'slowest_s': slowest_s}))
