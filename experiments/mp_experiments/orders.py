"""Orders and results of the packing tools."""
from .errors import ExperimentError
from .measurements import read_lines


class Orders:
    """Generates orders and runs the packing tools on them, each once; files stay beside the report."""

    def __init__(self, tools, folder, seed):
        self.tools, self.folder, self.seed = tools, folder, seed

    def generate(self, height_mm, count):
        path = self.folder / f'orders_{height_mm}.jsonl'
        arguments = ['--height_mm', height_mm, '--count', count, '--seed', self.seed, '--out']
        self.tools.run('generate_instances', arguments + [path], arguments + [path.name])
        return path

    def pack(self, orders, method, time_limit_s):
        return self._solve('pack', orders, method, ['--time_limit_s', time_limit_s])

    def plan(self, orders, method, budget_ms, rule='dblf'):
        return self._solve('plan_picks', orders, method, ['--budget_ms', budget_ms, '--rule', rule], f'_{rule}')

    def _solve(self, tool, orders, method, limits, suffix=''):
        path = self.folder / f'{tool}_{method}{suffix}_{orders.stem}.jsonl'
        common = ['--method', method, '--seed', self.seed, *limits]
        self.tools.run(tool, ['--instances', orders, *common, '--out', path],
                       ['--instances', orders.name, *common, '--out', path.name])
        self.tools.run('check_packing', ['--instances', orders, '--results', path],
                       ['--instances', orders.name, '--results', path.name])
        results = read_lines(path)
        if not results:
            raise ExperimentError(f'{path}: holds no result')
        return results


def unpacked_counts(results):
    return [len(result['unpacked']) for result in results]
