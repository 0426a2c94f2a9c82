"""Where and with what a report was made."""
import datetime
import os
import platform
import re
import subprocess

from .tools import PACKAGE_FOLDER


def package_version():
    try:
        text = (PACKAGE_FOLDER / 'package.xml').read_text(encoding='utf-8')
    except OSError:
        return 'unknown'
    match = re.search(r'<version>([^<]+)</version>', text)
    return match.group(1) if match else 'unknown'


def revision():
    """Git revision of the source folder, or nothing when it is installed."""
    command = ['git', '-C', str(PACKAGE_FOLDER), 'describe', '--always', '--dirty']
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, universal_newlines=True)
    except OSError:
        return ''
    return done.stdout.strip() if done.returncode == 0 else ''


def processor():
    try:
        with open('/proc/cpuinfo', encoding='utf-8') as file:
            for line in file:
                if line.startswith('model name'):
                    return line.split(':', 1)[1].strip()
    except OSError:
        pass
    return platform.machine()


def facts():
    """Pairs of name and value."""
    version = package_version() + (f' ({revision()})' if revision() else '')
    return [('version', version),
            ('date', datetime.datetime.now().strftime('%Y-%m-%d %H:%M')),
            ('processor', f'{processor()}, {os.cpu_count()} cores'),
            ('system', f'{platform.system()} {platform.release()}, Python {platform.python_version()}')]
