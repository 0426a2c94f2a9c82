"""Small tables of signed errors: ours and the thesis' chain beside what the thesis prints."""
from .page import Row
from .statistics import mean, number, rms, stddev

METHODS = (('thesis', "thesis' chain, measured here"), ('best', 'ours'))


def error_rows(columns, name, digits=2, kind=''):
    """Rows mean, RMS and standard deviation of several columns of signed errors."""
    statistics = (('mean error', mean), ('root mean square', rms), ('standard deviation', stddev))
    rows = []
    for i, (label, statistic) in enumerate(statistics):
        rows.append(Row([name if i == 0 else '', label] + [number(statistic(c), digits) for c in columns],
                        kind or ('group' if i == 0 else '')))
    return rows


def printed_rows(name, table, digits=2):
    """The same rows from printed figures: one (mean, RMS, standard deviation) a column."""
    labels = ('mean error', 'root mean square', 'standard deviation')
    return [Row([name if i == 0 else '', label] + [number(column[i], digits) for column in table],
                'group' if i == 0 else '') for i, label in enumerate(labels)]


def by_column(printed, columns):
    """A printed table {'mean': (...), 'rms': (...), 'std': (...)} as (mean, RMS, standard deviation) a column."""
    return [(printed['mean'][i], printed['rms'][i], printed['std'][i]) for i in range(columns)]
