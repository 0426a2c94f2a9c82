"""What a torture test tried, and its row for the table of scripts/torture.sh."""
import contextlib
import json


class Counts:
    def __init__(self, test):
        self.test = test
        self.tried = self.survived = 0
        self.lost = []        # what failed, in words
        self.recovery_s = []  # until the next good answer

    @contextlib.contextmanager
    def attempt(self, what):
        """One that survives when nothing is thrown. Others go on; `lost` tells at the end (rostest does not count subTests)."""
        self.tried += 1
        try:
            yield
        except Exception as error:  # pylint: disable=broad-except
            self.lost.append('%s: %s: %s' % (what, type(error).__name__, error))
        else:
            self.survived += 1

    def slowest_s(self):
        return max(self.recovery_s, default=0.0)

    def write(self, path, with_p99=True):
        """To the file of the parameter ~table; without a name nowhere."""
        if not path:
            return
        times = sorted(self.recovery_s) or [0.0]
        p99_s = times[min(len(times) - 1, int(0.99 * len(times)))] if with_p99 else None
        with open(path, 'w', encoding='utf-8') as out:
            json.dump({'test': self.test, 'tried': self.tried, 'survived': self.survived,
                       'lost': self.tried - self.survived, 'p99_s': p99_s, 'slowest_s': round(self.slowest_s(), 3)}, out)
