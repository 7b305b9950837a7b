"""Draws free-response curves of evaluations: found share against false findings per inspection.

usage: free_response.py EVALUATION.json... PICTURE.png

An evaluation of a static camera yields one panel for each number of frames; one of a moved camera yields a single panel.
"""
import json
import pathlib
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt

MARKERS = {'constant': '^', 'gaussian': 's', 'calibrated': 'o', 'octree': 'v', 'spatial': 'o'}


def curve(axes, tallies, label, found, targets, share_95):
    # A rate of zero is drawn at the upper end of its interval, since a logarithmic axis cannot show 0.
    false = [t['false_when_clean'] / t['inspections'] or t['false_rate_95'][1] for t in tallies]
    shares = [t[found] / t[targets] for t in tallies]
    errors = [[s - t[share_95][0] for s, t in zip(shares, tallies)],
              [t[share_95][1] - s for s, t in zip(shares, tallies)]]
    axes.errorbar(false, shares, yerr=errors, marker=MARKERS[tallies[0]['method']], label=label)
    for x, y, t in zip(false, shares, tallies):
        axes.annotate(f"{t['setting']:g}", (x, y), textcoords='offset points', xytext=(4, 5), fontsize=7)


def stayed(tallies):
    """The panels of a static camera: title, label of the vertical axis, and a function that draws the panel."""
    for frames in sorted({t['frames'] for t in tallies}):
        def draw(axes, frames=frames):
            for method in ('constant', 'gaussian', 'calibrated'):
                chosen = [t for t in tallies if t['method'] == method and t['frames'] == frames]
                curve(axes, chosen, method, 'found', 'targets', 'found_share_95')
        yield f'{frames} frames', 'share of the visible debris found', draw


def moved(tallies):
    """The panel of a moved camera: title, label of the vertical axis, and a function that draws the panel."""
    def draw(axes):
        for method, captures in sorted({(t['method'], t['captures']) for t in tallies}):
            chosen = [t for t in tallies if (t['method'], t['captures']) == (method, captures)]
            label = method if method == 'octree' else f"{captures} capture{'s' if captures > 1 else ''} a side"
            curve(axes, chosen, label, 'big_found', 'big', 'big_share_95')
    yield 'camera moved', 'share of the big debris found', draw


def panels_of(path):
    evaluation = json.loads(pathlib.Path(path).read_text())
    return (moved if evaluation['format'] == 'rva-evaluation-moved' else stayed)(evaluation['tallies'])


def main():
    *evaluations, picture = sys.argv[1:]
    panels = [panel for path in evaluations for panel in panels_of(path)]
    figure, plots = plt.subplots(1, len(panels), figsize=(max(4.5 * len(panels), 7), 4), squeeze=False)
    for axes, (title, share, draw) in zip(plots[0], panels):
        draw(axes)
        axes.set_xscale('log')
        axes.set_ylim(0, 1)
        axes.set_title(title)
        axes.set_xlabel('false findings per unchanged inspection')
        axes.set_ylabel(share)
        axes.legend(loc='best')
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


if __name__ == '__main__':
    main()
