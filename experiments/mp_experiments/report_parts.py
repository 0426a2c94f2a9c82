"""Parts that every report has."""
from . import machine


def add_facts(page, more):
    page.table([], [[name, value] for name, value in machine.facts() + list(more)], kind='facts')


def add_commands(page, tools):
    page.heading('Commands')
    page.text('What was measured, in this order, with the seconds each took.')
    page.code([f'{seconds:7.1f} s  {text}' for text, seconds in tools.commands])
