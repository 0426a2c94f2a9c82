#!/usr/bin/env python3
"""Checks the arrows between the rooms: reads every #include below include/ and src/ and fails on a wrong one.

usage: check_layers.py [ROOT]      (exit code 1 and one line per fault; 0 and a count otherwise)
"""
import pathlib
import re
import sys

PACKAGE = 'mixed_palletizing'

# room: (rooms it may include, prefixes of third-party headers it may include)
CORE_ROOMS = {
    'geometry': ((), ('Eigen/',)),
    'detection': (('geometry',), ('Eigen/', 'pcl/', 'opencv2/')),
    'packing': (('geometry',), ()),
    'planning': (('packing', 'geometry'), ('sqlite3.h', 'nlohmann/', 'fcntl.h', 'sys/stat.h', 'unistd.h')),  # the journal's files
    'instances': (('packing', 'geometry'), ('nlohmann/',)),
    'simulation': (('geometry',), ('Eigen/', 'embree3/', 'assimp/', 'opencv2/', 'yaml-cpp/', 'nlohmann/')),
    'experiments': (('geometry', 'detection', 'packing', 'planning', 'instances', 'simulation'),
                    ('Eigen/', 'opencv2/', 'nlohmann/')),
}
# What may know ROS and every core room: the adapters with their parts, and the nodes; each with those of them it may include.
JOINING_ROOMS = {
    'adapters': (),
    'adapters/captures': ('adapters',),
    'adapters/cell': ('adapters', 'adapters/captures'),
    'adapters/converters': ('adapters',),
    'adapters/rviz_panel': ('adapters',),
    'nodes': ('adapters', 'adapters/captures', 'adapters/cell', 'adapters/converters'),
}

STANDARD_HEADER = re.compile(r'^[a-z_0-9]+$')
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
# The core neither talks, waits, ends the process, nor reads the wall clock.
FORBIDDEN_IN_CORE = re.compile(
    r'\bstd::(cout|cerr|clog)\b|\bf?printf\s*\(|\bsleep_(for|until)\b|\bu?sleep\s*\(|\bsystem_clock\b'
    r'|\b(std::)?(exit|abort|terminate)\s*\(|\bassert\s*\(|\bstd::time\s*\(')


def room_in(folders):
    """Room of a file in these folders, the outermost first; a part of the adapters is a room of its own."""
    part = '/'.join(folders[:2])
    return part if part in JOINING_ROOMS else folders[0]


def room_of(path):
    """Room of a file relative to the package root, or None."""
    parts = path.parts
    if parts[0] == 'include' and len(parts) > 3:
        return room_in(parts[2:-1])
    if parts[0] == 'src' and len(parts) > 2:
        return room_in(parts[1:-1])
    return None


def include_fault(room, quote, target):
    """What is wrong with one include of a file in `room`, or None."""
    if quote == '"':
        return f'"{target}" leaves its folder' if '/' in target else None
    if target.startswith(PACKAGE + '/'):
        inner = target[len(PACKAGE) + 1:]
        if '/' not in inner:  # a generated message
            return f'generated message <{target}> in a core room' if room in CORE_ROOMS else None
        other = room_in(inner.split('/')[:-1])
        if other == room:
            return None
        if room in CORE_ROOMS:
            return None if other in CORE_ROOMS[room][0] else f'{room} must not see {other}'
        if other in CORE_ROOMS or other in JOINING_ROOMS.get(room, ()):
            return None
        return f'{room} must not see {other}'
    if room in CORE_ROOMS and not STANDARD_HEADER.match(target):
        if not target.startswith(CORE_ROOMS[room][1]):
            return f'{room} must not include <{target}>'
    return None


def faults_of(path, text):
    room = room_of(path)
    if room is None:
        return [f'{path}: lies in no room']
    if room not in CORE_ROOMS and room not in JOINING_ROOMS:
        return [f'{path}: unknown room {room}']
    faults = []
    for number, line in enumerate(text.splitlines(), 1):
        code = line.split('//')[0]
        match = INCLUDE.match(line)
        if match:
            fault = include_fault(room, match.group(1), match.group(2))
            if fault:
                faults.append(f'{path}:{number}: {fault}')
        elif room in CORE_ROOMS and FORBIDDEN_IN_CORE.search(code):
            faults.append(f'{path}:{number}: a core room must not use {FORBIDDEN_IN_CORE.search(code).group(0)}')
    return faults


def check(root):
    files = sorted(p for top in ('include', 'src') for p in (root / top).rglob('*')
                   if p.suffix in ('.hpp', '.cpp', '.h'))
    faults = [f for p in files for f in faults_of(p.relative_to(root), p.read_text(encoding='utf-8'))]
    return files, faults


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    files, faults = check(root)
    if not files:
        sys.exit(f'check_layers: no sources below {root}')
    print('\n'.join(faults) if faults else f'layers: {len(files)} files, no wrong arrow')
    sys.exit(1 if faults else 0)


if __name__ == '__main__':
    main()
