"""Pictures as bytes, drawn by matplotlib."""
import io

from .errors import ExperimentError

try:
    import matplotlib
    matplotlib.use('Agg')
    from matplotlib import pyplot, ticker
except ImportError as error:
    raise ExperimentError(f'matplotlib cannot be imported ({error}): install python3-matplotlib')

OURS, THEIRS, TRUTH, FOUND, WRONG = '#2166ac', '#b2622b', '#20a050', '#1450ff', '#e02020'
SERIES = ('#999999', THEIRS, OURS, TRUTH)


def as_bytes(figure, kind='png'):
    memory = io.BytesIO()
    figure.savefig(memory, format=kind, dpi=100)
    pyplot.close(figure)
    return memory.getvalue()


def _bins(series):
    values = [v for _, list_of_values, _ in series for v in list_of_values]
    low, high = min(values), max(values)
    if high - low < 1e-9:
        low, high = low - 0.5e-3, high + 0.5e-3
    return [low + (high - low) * i / 30 for i in range(31)]


def histograms(panels):
    """Panels (title, unit, [(name, values, colour)]) in one row; None when there is nothing to draw."""
    panels = [(title, unit, [s for s in series if s[1]]) for title, unit, series in panels]
    panels = [panel for panel in panels if panel[2]]
    if not panels:
        return None
    figure, axes = pyplot.subplots(1, len(panels), figsize=(3.6 * len(panels) + 0.6, 2.9), squeeze=False)
    for axis, (title, unit, series) in zip(axes[0], panels):
        bins = _bins(series)
        for name, values, colour in series:
            axis.hist(values, bins=bins, color=colour, alpha=0.6, label=name)
        axis.axvline(0.0, color='#888', linewidth=0.8)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(unit, fontsize=9)
        axis.tick_params(labelsize=8)
        axis.xaxis.set_major_locator(ticker.MaxNLocator(5))
        axis.yaxis.set_major_locator(ticker.MaxNLocator(5, integer=True))
    axes[0][0].legend(fontsize=8, frameon=False)
    figure.tight_layout()
    return as_bytes(figure)


def count_bars(panels, unit):
    """Panels (title, [(name, whole numbers, colour)]): how often each number occurs, the series side by side."""
    figure, axes = pyplot.subplots(1, len(panels), figsize=(3.6 * len(panels) + 0.6, 2.9), squeeze=False)
    for axis, (title, series) in zip(axes[0], panels):
        width = 0.8 / len(series)
        for i, (name, values, colour) in enumerate(series):
            numbers = sorted(set(values))
            places = [n + width * (i - 0.5 * (len(series) - 1)) for n in numbers]
            axis.bar(places, [values.count(n) for n in numbers], width=width, color=colour, label=name)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel(unit, fontsize=9)
        axis.tick_params(labelsize=8)
        axis.xaxis.set_major_locator(ticker.MaxNLocator(8, integer=True))
        axis.yaxis.set_major_locator(ticker.MaxNLocator(5, integer=True))
    axes[0][0].set_ylabel('orders', fontsize=9)
    axes[0][0].legend(fontsize=8, frameon=False)
    figure.tight_layout()
    return as_bytes(figure)


def ratio_curves(series, level):
    """Curves (name, heights [mm], ratios) on a logarithmic scale with a dashed level; an empty name repeats the last."""
    figure, axis = pyplot.subplots(figsize=(7.0, 3.6))
    colours = {}
    name = ''
    for label, x, y in series:
        name = label or name
        colour = colours.setdefault(name, (OURS, THEIRS)[len(colours) % 2])
        axis.plot(x, y, label=label or None, linewidth=1.0, color=colour, alpha=0.8)
    axis.axhline(level, color='#555', linestyle='--', linewidth=0.9)
    axis.set_yscale('log')
    axis.set_xlim(-20, 6)
    axis.set_xlabel('mm above the height', fontsize=9)
    axis.set_ylabel('ratio', fontsize=9)
    axis.tick_params(labelsize=8)
    axis.legend(fontsize=8, frameon=False)
    figure.tight_layout()
    return as_bytes(figure)


def curves(series, over, what):
    """Curves (name, positive numbers, values, colour) over the logarithm of the numbers."""
    figure, axis = pyplot.subplots(figsize=(7.0, 3.6))
    for name, numbers, values, colour in series:
        axis.plot(numbers, values, marker='o', markersize=4, linewidth=1.2, color=colour, label=name)
    axis.set_xscale('log')
    places = sorted({number for _, numbers, _, _ in series for number in numbers})
    axis.set_xticks(places)
    axis.set_xticks([], minor=True)
    axis.set_xticklabels([f'{place:g}' for place in places])
    axis.set_xlabel(over, fontsize=9)
    axis.set_ylabel(what, fontsize=9)
    axis.tick_params(labelsize=8)
    axis.legend(fontsize=8, frameon=False)
    figure.tight_layout()
    return as_bytes(figure)


def _outline(axis, corners, colour, style='-', width=1.4):
    xs = [c[0] for c in corners] + [corners[0][0]]
    ys = [c[1] for c in corners] + [corners[0][1]]
    axis.plot(xs, ys, color=colour, linestyle=style, linewidth=width)


def scene(picture_path, record, points=()):
    """The colours of a scene with the true tops (dashed green), found ones (blue) and invented ones (red).

    `points` are (column, row, colour) crosses."""
    try:
        image = pyplot.imread(str(picture_path))
    except (OSError, SyntaxError, ValueError) as error:
        raise ExperimentError(f'{picture_path}: {error}')
    height, width = image.shape[:2]
    figure = pyplot.figure(figsize=(9.0, 9.0 * height / width))
    axis = figure.add_axes([0, 0, 1, 1])
    axis.imshow(image)
    for box in record['boxes']:
        _outline(axis, box['truth']['corners_px'], TRUTH, '--')
        if box['found']:
            _outline(axis, box['found']['corners_px'], FOUND)
    for box in record['invented']:
        _outline(axis, box['corners_px'], WRONG)
    for column, row, colour in points:
        axis.plot([column], [row], marker='x', color=colour, markersize=9, markeredgewidth=2)
    axis.set_xlim(0, width - 1)
    axis.set_ylim(height - 1, 0)
    axis.axis('off')
    return as_bytes(figure, 'jpg')
