"""Draws free-response curves of an evaluation: found share against false findings per inspection.

usage: free_response.py EVALUATION.json PICTURE.png
"""
import json
import pathlib
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt

STYLES = {'constant': ('C2', '^'), 'gaussian': ('C0', 's'), 'calibrated': ('C1', 'o')}


def draw(axes, tallies, frames):
    for method, (color, marker) in STYLES.items():
        chosen = [t for t in tallies if t['method'] == method and t['frames'] == frames]
        # None seen is drawn at the upper end of its interval: a logarithm has no place for nothing.
        false = [max(t['false_when_clean'], 0) / t['inspections'] or t['false_rate_95'][1] for t in chosen]
        found = [t['found'] / t['targets'] for t in chosen]
        errors = [[f - t['found_share_95'][0] for f, t in zip(found, chosen)],
                  [t['found_share_95'][1] - f for f, t in zip(found, chosen)]]
        axes.errorbar(false, found, yerr=errors, color=color, marker=marker, linestyle='-', label=method)
        for x, y, t in zip(false, found, chosen):
            axes.annotate(f"{t['setting']:g}", (x, y), textcoords='offset points', xytext=(4, 5), fontsize=7)
    axes.set_xscale('log')
    axes.set_ylim(0, 1)
    axes.set_title(f'{frames} frames')
    axes.set_xlabel('false findings per unchanged inspection')


def main():
    tallies = json.loads(pathlib.Path(sys.argv[1]).read_text())['tallies']
    counts = sorted({t['frames'] for t in tallies})
    figure, panels = plt.subplots(1, len(counts), figsize=(4.5 * len(counts), 4), squeeze=False)
    for axes, frames in zip(panels[0], counts):
        draw(axes, tallies, frames)
    panels[0][0].set_ylabel('share of the visible debris found')
    panels[0][0].legend(loc='lower right')
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=100)


if __name__ == '__main__':
    main()
