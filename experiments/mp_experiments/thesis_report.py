"""`run_experiments detection --thesis`: chapter 4.1 of the source thesis again, table by table."""
from . import thesis_features, thesis_stages
from .page import Page
from .report_parts import add_commands, add_facts

INTRODUCTION = (
    "The experiments of chapter 4.1 of the source thesis, on the simulator. Every table shows what the thesis prints, what "
    "its own chain gives here, and what the detector gives. Scenes and noise are ours, so the figures of the thesis' chain "
    "need not be those that it prints; our frame has z up: x is the thesis' x, y its -z, z its y. Signed errors are found "
    "minus true.")

# Scenes of each experiment in the thesis, and in a quick run.
COUNTS = {'orientation': (50, 4), 'separated': (22, 3), 'touching': (22, 3), 'torn': (22, 3), 'position': (50, 4),
          'yaw': (50, 4), 'size': (100, 4), 'occlusion': (50, 4), 'tops': (30, 3)}


def make(tools, measurer, options, out):
    counts = {name: options.count or (quick if options.quick else full) for name, (full, quick) in COUNTS.items()}
    page = Page('The detection experiments of the thesis')
    add_facts(page, [('seed', options.seed), ('scenes', ', '.join(f'{n} {c}' for n, c in counts.items()))])
    page.text(INTRODUCTION)
    for section in (thesis_stages.base_frame, thesis_stages.clustering, thesis_stages.tops, thesis_stages.edges,
                    thesis_features.height, thesis_features.position, thesis_features.occlusion,
                    thesis_features.orientation, thesis_features.size, thesis_features.run_time):
        tools.say(section.__doc__)
        section(page, measurer, counts)
    add_commands(page, tools)
    path = out / 'detection_thesis.html'
    path.write_text(page.render(), encoding='utf-8')
    return path
