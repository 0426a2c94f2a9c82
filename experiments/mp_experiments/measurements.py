"""Detections measured by the tool measure_detection."""
import json

from .errors import ExperimentError
from .tools import recipe


class Measurement:
    """Records and summary of one recipe and method."""

    def __init__(self, name, method, records, summary):
        self.name, self.method, self.records, self.summary = name, method, records, summary

    def boxes(self):
        """Found boxes that must be found."""
        return [b for r in self.records for b in r['boxes'] if b['found'] and b['truth']['counts']]

    def errors(self, quantity):
        return [b['errors'][quantity] for b in self.boxes() if b['complete']]

    def record(self, index):
        return next(r for r in self.records if r['scene'] == index)


class Measurer:
    """Measures into a folder, that keeps the records beside the report."""

    def __init__(self, tools, folder, seed, threads=1):
        self.tools, self.folder, self.seed, self.threads = tools, folder, seed, threads
        self.known = {}  # what was measured already, by its arguments

    def measure(self, name, count, method='best', base='marker'):
        key = (name, count, method, base)
        if key not in self.known:
            self.known[key] = self._measure(*key)
        return self.known[key]

    def _measure(self, name, count, method, base):
        stem = f'{name}_{method}' + ('' if base == 'marker' else f'_{base}')
        out, summary = self.folder / f'{stem}.jsonl', self.folder / f'{stem}.json'
        common = ['--count', count, '--seed', self.seed, '--method', method, '--base', base, '--threads', self.threads]
        self.tools.run('measure_detection',
                       ['--recipe', recipe(name), *common, '--out', out, '--summary', summary],
                       ['--recipe', f'config/recipes/{name}.yaml', *common, '--out', out.name])
        return Measurement(name, method, read_lines(out), read_lines(summary)[0])

    def tops(self, name, count, thresholds_mm):
        """Records of measure_tops: the variants of the thesis' separation of tops and of its formulas."""
        key = (name, count, tuple(thresholds_mm))
        if key not in self.known:
            out = self.folder / f'{name}_tops.jsonl'
            common = ['--count', count, '--seed', self.seed]
            if thresholds_mm:
                common += ['--thresholds-mm', *thresholds_mm]
            self.tools.run('measure_tops', ['--recipe', recipe(name), *common, '--out', out],
                           ['--recipe', f'config/recipes/{name}.yaml', *common, '--out', out.name])
            self.known[key] = read_lines(out)
        return self.known[key]

    def picture(self, name, scene):
        """File with the colours of one scene."""
        path = self.folder / f'{name}_{scene}.png'
        if not path.exists():
            self.tools.run('measure_detection',
                           ['--recipe', recipe(name), '--first', scene, '--count', 0, '--seed', self.seed,
                            '--out', self.folder / 'picture.jsonl', '--picture', path],
                           ['--recipe', f'config/recipes/{name}.yaml', '--first', scene, '--count', 0, '--seed', self.seed,
                            '--out', 'picture.jsonl', '--picture', path.name])
            (self.folder / 'picture.jsonl').unlink()
        return path


def read_lines(path):
    """JSON objects of a file, one a line."""
    try:
        with open(path, encoding='utf-8') as file:
            return [json.loads(line) for line in file if line.strip()]
    except (OSError, ValueError) as error:
        raise ExperimentError(f'{path}: {error}')
