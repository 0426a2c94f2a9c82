"""A report as one HTML file that needs nothing else."""
import base64
import html

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #222; background: #fff; max-width: 1180px; margin: 2em auto;
  padding: 0 1em; }
h1 { font-size: 1.7em; margin-bottom: .2em; } h2 { font-size: 1.25em; margin-top: 2.2em; border-bottom: 1px solid #ddd; }
h3 { font-size: 1.05em; margin-top: 1.6em; }
table { border-collapse: collapse; margin: .8em 0; font-size: .92em; }
caption { text-align: left; color: #555; padding-bottom: .3em; }
th, td { padding: .22em .7em; border-bottom: 1px solid #e6e6e6; text-align: right; vertical-align: top; }
th:first-child, td:first-child { text-align: left; } thead th { border-bottom: 2px solid #bbb; font-weight: 600; }
tr.group td { border-top: 2px solid #ccc; } tr.soft td { color: #777; }
tr.title td { font-weight: 600; } .wide th, .wide td { padding: .22em .35em; } .wide { font-size: .86em; }
.wide td:first-child { white-space: nowrap; }
td.good { color: #17692c; font-weight: 600; } td.bad { color: #b3261e; font-weight: 600; }
figure { margin: 1em 0; } figure img { max-width: 100%; } figcaption { color: #555; font-size: .92em; }
.gallery { display: flex; flex-wrap: wrap; gap: 1em; } .gallery figure { flex: 1 1 480px; max-width: 570px; margin: 0; }
pre { background: #f6f6f4; padding: .7em; overflow-x: auto; font-size: .85em; } .facts td { text-align: left; }
.layers { display: flex; flex-wrap: wrap; gap: .8em; } .layers figure { margin: 0; } svg { max-width: 100%; }
svg text { fill: #222; } .tint { display: inline-block; width: .9em; height: .9em; border: 1px solid #555; } th.words,
td.words { text-align: left; } input[type=range] { width: 24em; vertical-align: middle; }
"""


class Cell:
    """A cell with a class: 'good' or 'bad'; a text over several columns ends its row."""

    def __init__(self, text, kind='', columns=1):
        self.text, self.kind, self.columns = text, kind, columns


class Row(list):
    """A row with classes: 'group' starts a group, 'title' names it, 'soft' is background."""

    def __init__(self, cells, kind=''):
        super().__init__(cells)
        self.kind = kind


def _text(value):
    return str(getattr(value, 'text', value))


def _columns(value):
    return getattr(value, 'columns', 1)


def _cell(value, words, tag='td'):
    kind = ' '.join(word for word in (getattr(value, 'kind', ''), 'words' if words or _columns(value) > 1 else '') if word)
    span = f' colspan="{_columns(value)}"' if _columns(value) > 1 else ''
    text = html.escape(_text(value))
    for apart in (' mm', ' %', ' ms', '≥ ', '≤ '):
        text = text.replace(apart, apart.replace(' ', '\N{NO-BREAK SPACE}'))
    return f'<{tag} class="{kind}"{span}>{text}</{tag}>' if kind else f'<{tag}>{text}</{tag}>'


def _cells(values, words, tag='td'):
    return ''.join(_cell(value, column in words, tag) for column, value in enumerate(values))


def _row(row, words):
    kind = getattr(row, 'kind', '')
    start = f'<tr class="{kind}">' if kind else '<tr>'
    return start + _cells(row, words) + '</tr>'


def _word_columns(rows):
    """Columns beside the first in which something begins with a letter: read from the left, numbers from the right."""
    return {column for row in rows for column, value in enumerate(row)
            if column > 0 and _columns(value) == 1 and _text(value)[:1].isalpha()}


class Page:
    def __init__(self, title):
        self.title = title
        self.parts = [f'<h1>{html.escape(title)}</h1>']

    def heading(self, text, level=2):
        self.parts.append(f'<h{level}>{html.escape(text)}</h{level}>')

    def text(self, text):
        self.parts.append(f'<p>{html.escape(text)}</p>')

    def table(self, headers, rows, caption='', kind=''):
        """Rows are lists of values, Cells or Rows."""
        rows = list(rows)
        words = _word_columns(rows)
        head = _cells(headers, words, 'th')
        body = '\n'.join(_row(row, words) for row in rows)
        title = f'<caption>{html.escape(caption)}</caption>' if caption else ''
        start = f'<table class="{kind}">' if kind else '<table>'
        head = f'<thead><tr>{head}</tr></thead>' if headers else ''
        self.parts.append(f'{start}{title}{head}<tbody>\n{body}\n</tbody></table>')

    def raw(self, text):
        """HTML as it is."""
        self.parts.append(text)

    def figure(self, picture, caption=''):
        self.parts.append(self._figure(picture, caption))

    def gallery(self, pictures, kind='gallery'):
        """Pairs of picture and caption, side by side where there is room."""
        self.parts.append(f'<div class="{kind}">' + '\n'.join(self._figure(p, c) for p, c in pictures) + '</div>')

    def code(self, lines):
        self.parts.append('<pre>' + html.escape('\n'.join(lines)) + '</pre>')

    def render(self):
        body = '\n'.join(self.parts)
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(self.title)}</title>'
                f'<style>{STYLE}</style></head>\n<body>\n{body}\n</body></html>\n')

    @staticmethod
    def _figure(picture, caption):
        """The bytes of a JPEG, PNG or SVG."""
        if picture[:4] == b'<svg':
            return f'<figure>{picture.decode()}<figcaption>{html.escape(caption)}</figcaption></figure>'
        kind = 'jpeg' if picture[:2] == b'\xff\xd8' else 'png'
        data = base64.b64encode(picture).decode('ascii')
        return (f'<figure><img alt="{html.escape(caption)}" src="data:image/{kind};base64,{data}">'
                f'<figcaption>{html.escape(caption)}</figcaption></figure>')
