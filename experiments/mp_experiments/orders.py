"""Orders and results of the packing tools."""
from .errors import ExperimentError
from .measurements import read_lines


class Orders:
    """Generates orders and runs the packing tools on them, each once; files stay beside the report."""

    def __init__(self, tools, folder, seed, threads=1):
        self.tools, self.folder, self.seed, self.threads = tools, folder, seed, threads
        self.reading = {}  # arguments by which the tools read a file, by its path

    def generate(self, height_mm, count, kind='', more=()):
        """File of generated orders; `more` arguments of the generator make a `kind`."""
        path = self.folder / ('_'.join(filter(None, ['orders', kind, str(height_mm)])) + '.jsonl')
        arguments = ['--height_mm', height_mm, '--count', count, '--seed', self.seed, *more, '--out']
        self.tools.run('generate_instances', arguments + [path], arguments + [path.name])
        return path

    def foreign(self, path, arguments):
        """Registers a file that the tools read by these arguments."""
        self.reading[path] = list(arguments)
        return path

    def pack(self, orders, method, time_limit_s, more=()):
        return self._solve('pack', orders, method, ['--time_limit_s', time_limit_s, *more])

    def plan(self, orders, method, budget_ms, more=(), label=''):
        """`label` tells results of one file and method apart; plain ones have none."""
        limits = ['--budget_ms', f'{budget_ms:g}', '--threads', self.threads, *more]
        return self._solve('plan_picks', orders, method, limits, label)

    def _solve(self, tool, orders, method, limits, label=''):
        path = self.folder / ('_'.join(filter(None, [tool, method, label, orders.stem])) + '.jsonl')
        reading = self.reading.get(orders, [])
        common = [*reading, '--method', method, '--seed', self.seed, *limits]
        self.tools.run(tool, ['--instances', orders, *common, '--out', path],
                       ['--instances', orders.name, *common, '--out', path.name])
        self.tools.run('check_packing', ['--instances', orders, *reading, '--results', path],
                       ['--instances', orders.name, *reading, '--results', path.name])
        results = read_lines(path)
        if not results:
            raise ExperimentError(f'{path}: holds no result')
        return results


def unpacked_counts(results):
    return [len(result['unpacked']) for result in results]


def utilizations(results):
    """In percent, by the order's name."""
    return {result['name']: 100.0 * result['utilization'] for result in results}
