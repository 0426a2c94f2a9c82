"""Finds and runs the C++ tools of the package."""
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

from .errors import ExperimentError

PACKAGE_FOLDER = pathlib.Path(__file__).resolve().parents[2]  # source folder or share/mixed_palletizing


def recipe(name):
    """Path of a shipped recipe."""
    path = PACKAGE_FOLDER / 'config' / 'recipes' / f'{name}.yaml'
    if not path.is_file():
        raise ExperimentError(f'recipe {path} is missing')
    return path


class Tools:
    """Runs tools, remembers the command lines and their times, shows progress on stderr."""

    def __init__(self, script_folder, quiet=False):
        prefixes = [pathlib.Path(p) for p in os.environ.get('CMAKE_PREFIX_PATH', '').split(':') if p]
        self.folders = [script_folder] + [prefix / 'lib' / 'mixed_palletizing' for prefix in prefixes]
        self.quiet = quiet
        self.commands = []  # (text, seconds)
        self.expected = 0   # commands in all; 0 = not known

    def find(self, name):
        for folder in self.folders:
            path = folder / name
            if path.is_file() and os.access(path, os.X_OK):
                return path
        found = shutil.which(name)
        if found:
            return pathlib.Path(found)
        raise ExperimentError(f'tool {name} not found: build the package and source its setup.bash')

    def say(self, text):
        if not self.quiet:
            print(text, file=sys.stderr, flush=True)

    def bar(self, width=20):
        """How many of the expected commands are done."""
        if not self.expected:
            return ''
        done = min(len(self.commands), self.expected)
        filled = width * done // self.expected
        return f'[{"#" * filled}{"." * (width - filled)}] {done}/{self.expected}'

    def run(self, name, arguments, shown=None):
        """Output of a tool. `shown` replaces the arguments in the report: paths without the machine's folders."""
        command = [str(self.find(name))] + [str(a) for a in arguments]
        text = ' '.join(['rosrun mixed_palletizing', name] + [shlex.quote(str(a)) for a in shown or arguments])
        self.say(self.bar() + '  ' + text)
        start = time.monotonic()
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        except OSError as error:
            raise ExperimentError(f'{command[0]}: {error.strerror}')
        if done.returncode != 0:
            lines = done.stderr.strip().splitlines() or [f'exit code {done.returncode}']
            raise ExperimentError(f'{name} failed: {lines[-1]}')
        self.commands.append((text, time.monotonic() - start))
        return done.stdout
