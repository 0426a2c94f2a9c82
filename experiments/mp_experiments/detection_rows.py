"""The rows of the detection table: which recipe, and what is wanted of it.

Limits: least recall and precision; largest mean position [mm], mean yaw [deg], RMS of lengths and widths [mm],
mean height error [mm]. `truncated` rows are judged by their flags instead.
"""


class DetectionRow:
    def __init__(self, recipe, title, limits=None, truncated=False):
        self.recipe, self.title, self.limits, self.truncated = recipe, title, limits or {}, truncated


def _limits(recall, precision, position, yaw, side, height):
    return {'recall': recall, 'precision': precision, 'position': position, 'yaw': yaw, 'side': side, 'height': height}


ROWS = (
    DetectionRow('separated_depth_noise', 'separated boxes, depth noise only', _limits(1, 1, 0.3, 0.03, 0.4, 0.1)),
    DetectionRow('separated_noise_x4', 'the same with four times the noise', _limits(1, 1, 0.5, 0.05, 1.0, 0.3)),
    DetectionRow('separated_all_effects', 'with shadows, flying pixels, drop-outs', _limits(1, 1, 0.5, 0.05, 0.7, 0.1)),
    DetectionRow('touching_equal', 'two or three boxes face to face, equal height',
                 _limits(0.95, 0.97, 1.0, 0.1, 2.0, 0.2)),
    DetectionRow('touching_stepped', 'two or three boxes face to face, stepped',
                 _limits(0.95, 0.97, 1.0, 0.1, 2.0, 0.2)),
    DetectionRow('banded', 'dark band across the top and down the sides', _limits(0.98, 0.98, 0.7, 0.05, 1.0, 0.1)),
    DetectionRow('hidden', 'a taller box hides 8 to 60 % of a top', _limits(0.95, 0.97, 2.0, 0.1, 2.0, 0.2)),
    DetectionRow('uneven', 'bulges, sagging, flaps, rounded edges, dents', _limits(0.99, 0.99, 3.0, 0.1, 3.0, 0.5)),
    DetectionRow('truncated', 'partly outside the image', truncated=True),
    DetectionRow('everything', 'all of it at once, 3 to 6 boxes', _limits(0.85, 0.95, 3.0, 0.15, 5.0, 1.0)),
)

# What the summaries call the limits: (key of the summary, statistic or None).
MEASURED = {'recall': ('recall', None), 'precision': ('precision', None), 'position': ('position_mm', 'mean'),
            'yaw': ('yaw_deg', 'mean'), 'side': ('side_mm', 'rms'), 'height': ('height_mm', 'mean')}


def measured(summary, limit):
    """The figure that a limit is for; None when nothing was measured."""
    key, statistic = MEASURED[limit]
    value = summary[key]
    if statistic is None:
        return value
    return value[statistic] if value['count'] else None


def holds(row, summary, limit, margin=1.0):
    """Whether a figure keeps its limit; errors may be `margin` times as large."""
    value = measured(summary, limit)
    if limit in ('recall', 'precision'):
        return value >= row.limits[limit]
    return value is not None and value <= margin * row.limits[limit]


def truncated_holds(summary):
    """Boxes outside the image are found at all, every one of them says so, and no size is wrong beyond its standard deviation."""
    return ((summary['truncated_found'] > 0 or summary['truncated'] == 0) and
            summary['truncated_flagged'] == summary['truncated_found'] and summary['sizes_beyond_stddev'] == 0)
