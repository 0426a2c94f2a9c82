"""The processes behind the nodes: which they are and what they use."""
import os
import statistics
import xmlrpc.client


def pid_of(node, master_uri=None):
    """Raises OSError or xmlrpc.client.Error when there is no such node."""
    master = xmlrpc.client.ServerProxy(master_uri or os.environ['ROS_MASTER_URI'])
    return xmlrpc.client.ServerProxy(master.lookupNode('/test', node)[2]).getPid('/test')[2]


class Use:
    """Memory, threads and open files of a process, from time to time."""

    def __init__(self, name, pid):
        self.name = name
        self._folder = '/proc/%d/' % pid
        self.memory_kb, self.threads, self.files = [], [], []

    def look(self):
        with open(self._folder + 'status', encoding='ascii') as status:
            values = dict(line.split(':', 1) for line in status)
        self.memory_kb.append(int(values['RssAnon'].split()[0]))
        self.threads.append(len(os.listdir(self._folder + 'task')))
        self.files.append(len(os.listdir(self._folder + 'fd')))

    def growth(self):
        """Of the memory: the last quarter of the looks over the second, less 1."""
        quarter = len(self.memory_kb) // 4
        return statistics.median(self.memory_kb[-quarter:]) / statistics.median(self.memory_kb[quarter:2 * quarter]) - 1.0

    def __str__(self):
        return '%s: %.1f MB, %+.2f %% after the warm-up, %d threads, %d files' % (
            self.name, self.memory_kb[-1] / 1024.0, 100.0 * self.growth(), self.threads[-1], self.files[-1])
