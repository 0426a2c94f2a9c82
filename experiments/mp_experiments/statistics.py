"""Figures of lists of signed errors."""
import math


def mean(values):
    return sum(values) / len(values) if values else math.nan


def rms(values):
    return math.sqrt(mean([v * v for v in values])) if values else math.nan


def stddev(values):
    """About the mean, divided by the number of values."""
    middle = mean(values)
    return rms([v - middle for v in values])


def quantile(values, share):
    """Nearest rank of the absolute values."""
    ordered = sorted(abs(v) for v in values)
    if not ordered:
        return math.nan
    return ordered[max(1, math.ceil(share * len(ordered))) - 1]


def number(value, digits=2):
    """Text of a number; a dash for none."""
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return '–'
    return f'{value:.{digits}f}'
