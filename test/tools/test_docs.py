#!/usr/bin/env python3
"""The documents tell the truth: links lead somewhere, quoted messages and named programs are in the code."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = [ROOT / 'README.md', *sorted((ROOT / 'docs').glob('*.md'))]
CODE = [path for folder in ('src', 'include', 'scripts', 'experiments', 'examples') for path in (ROOT / folder).rglob('*')
        if path.suffix in ('.cpp', '.hpp', '.py', '.sh', '')  and path.is_file() and '__pycache__' not in path.parts]
SHORTEST = 8  # characters of a quoted message that are looked for: fewer are found anywhere


def source_text():
    """All sources, string literals that follow each other joined."""
    texts = [path.read_text(encoding='utf-8', errors='replace') for path in CODE]
    return re.sub(r'"\s*\n\s*"', '', '\n'.join(texts))


def without_code(text):
    return re.sub(r'```.*?```', '', text, flags=re.S)


class Docs(unittest.TestCase):
    def test_links_lead_somewhere(self):
        count = 0
        for document in DOCUMENTS:
            for link in re.findall(r'\]\(([^)#\s]+)(?:#[^)]*)?\)', without_code(document.read_text(encoding='utf-8'))):
                if '://' in link:
                    continue
                count += 1
                self.assertTrue((document.parent / link).exists(), f'{document.name}: {link}')
        self.assertGreater(count, 10)

    def test_every_document_is_linked_from_the_readme(self):
        readme = (ROOT / 'README.md').read_text(encoding='utf-8')
        for document in DOCUMENTS[1:]:
            self.assertTrue(f'docs/{document.name}' in readme, document.name)

    def test_messages_of_troubleshooting_are_in_the_code(self):
        code = source_text()
        quoted = []
        for line in (ROOT / 'docs' / 'troubleshooting.md').read_text(encoding='utf-8').splitlines():
            if line.startswith('| `') or line.startswith('| … `'):
                quoted += re.findall(r'`([^`]+)`', line.split('|')[1])
        self.assertGreater(len(quoted), 20)
        for words in quoted:
            if len(words) >= SHORTEST:
                self.assertTrue(words.strip() in code, words)

    def test_programs_named_after_rosrun_exist(self):
        built = '\n'.join(path.read_text(encoding='utf-8')
                          for path in (ROOT / 'src' / 'nodes' / 'CMakeLists.txt', ROOT / 'CMakeLists.txt'))
        names = set()
        for document in DOCUMENTS:
            names |= set(re.findall(r'rosrun mixed_palletizing (\w[\w.]*)', document.read_text(encoding='utf-8')))
        self.assertGreater(len(names), 3)
        for name in names - {'NAME'}:
            self.assertRegex(built, rf'\b{re.escape(name)}\b', name)

    def test_launch_arguments_exist(self):
        known = {path.name: set(re.findall(r'<arg name="(\w+)"', path.read_text(encoding='utf-8')))
                 for path in (ROOT / 'launch').glob('*.launch')}
        count = 0
        for document in DOCUMENTS:
            text = document.read_text(encoding='utf-8').replace('\\\n', ' ')  # commands of several lines
            for file, words in re.findall(r'\b(\w+\.launch)((?: +\w+:=(?:"[^"]*"|[^\s`]*))+)', text):
                for name in re.findall(r'(\w+):=', words):
                    count += 1
                    self.assertIn(name, known[file], f'{document.name}: {file}')
        self.assertGreater(count, 10)

    def test_files_of_algorithms_exist(self):
        sources = {path.stem for path in (ROOT / 'src').rglob('*.cpp')} | {path.stem for path in (ROOT / 'include').rglob('*.hpp')}
        count = 0
        for line in (ROOT / 'docs' / 'algorithms.md').read_text(encoding='utf-8').splitlines():
            cells = line.split('|')
            if len(cells) != 6 or cells[3].strip() in ('file', '---'):
                continue
            for name in re.findall(r'`([^`]+)`', cells[3]):
                count += 1
                self.assertTrue(name in sources or (ROOT / name).exists(), name)
        self.assertGreater(count, 30)


if __name__ == '__main__':
    unittest.main()
