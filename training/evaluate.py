"""Measures a classifier on findings that it was not trained on, with OpenCV as RVA runs it.

usage: evaluate.py --model CARD.json --known DIR ... --unlisted DIR ... [--json OUT.json]

--known: findings of objects of the catalogue; --unlisted: of everyday objects outside it. False findings are counted
apart. Shares have 95 % intervals (Clopper-Pearson, by inspections' findings taken as independent).
"""
import argparse
import json
import pathlib
import time

import cv2
import numpy as np

from calibration import expected_calibration_error, probabilities, threshold_that_keeps
from findings import LABELS, Findings
from intervals import clopper_pearson


class Model:
    def __init__(self, card):
        self.card = json.loads(card.read_text())
        if self.card['labels'] != LABELS:
            raise SystemExit(f'{card}: has other labels than training/classes.json')
        self.net = cv2.dnn.readNetFromONNX(str(card.parent / self.card['model']))

    def probabilities(self, planes):
        self.net.setInput(planes[None].astype(np.float32))
        return probabilities(self.net.forward(), self.card['temperature'])[0]


class Judged:
    """Probabilities of all findings of some folders, and what is right."""

    def __init__(self, model, folders):
        findings = Findings(folders)
        self.all = np.array([model.probabilities(planes) for planes in findings.planes])
        self.labels, self.lit = findings.labels, findings.lit
        self.is_object = np.array([bool(one['kind']) for one in findings.described])
        self.best, self.named = self.all[:, :-1].max(1), self.all[:, :-1].argmax(1)
        self.unknown = self.best < model.card['least_probability']
        self.inspections = len({one['seed'] for one in findings.described})


def share(name, right):
    right = np.asarray(right)
    low, high = clopper_pearson(int(right.sum()), len(right))
    print(f'{name}: {100 * right.mean():.1f} % ({100 * low:.1f} to {100 * high:.1f}) of {len(right)}')
    return {'name': name, 'share': round(float(right.mean()), 4), 'low': round(low, 4), 'high': round(high, 4),
            'of': len(right)}


def confusion(judged, chosen):
    """Rows are objects, columns the class that they get; the last column is unknown."""
    counts = np.zeros((len(LABELS), len(LABELS) + 1), int)
    columns = np.where(judged.unknown, len(LABELS), judged.named)
    np.add.at(counts, (judged.labels[chosen], columns[chosen]), 1)
    return counts


def print_confusion(counts):
    names = [*LABELS, 'unknown']
    print('| | ' + ' | '.join(names) + ' |\n' + '| --- ' * (len(names) + 1) + '|')
    for label, row in zip(LABELS, counts):
        print(f'| {label} | ' + ' | '.join(str(n) if n else '' for n in row) + ' |')


def milliseconds(model):
    cv2.setNumThreads(1)
    planes = np.zeros((14, 48, 48), np.float32)
    times = []
    for _ in range(200):
        start = time.perf_counter()
        model.probabilities(planes)
        times.append(1000 * (time.perf_counter() - start))
    return float(np.median(times))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--model', type=pathlib.Path, required=True)
    parser.add_argument('--known', nargs='+', required=True)
    parser.add_argument('--unlisted', nargs='+', required=True)
    parser.add_argument('--json', type=pathlib.Path)
    options = parser.parse_args()
    model = Model(options.model)
    known, unlisted = Judged(model, options.known), Judged(model, options.unlisted)
    print(f'{known.inspections} and {unlisted.inspections} inspections')
    of_catalogue = known.labels < len(LABELS)
    right = known.named == known.labels
    others = unlisted.is_object
    false = np.concatenate([known.unknown[~known.is_object], unlisted.unknown[~unlisted.is_object]])
    shares = []
    for light, name in ((True, 'lit'), (False, 'dark')):
        at = of_catalogue & (known.lit == light)
        elsewhere = others & (unlisted.lit == light)
        kept = threshold_that_keeps(known.best[at], 0.9)
        shares += [share(f'{name}: most probable label right', right[at]),
                   share(f'{name}: known objects that get a class', ~known.unknown[at]),
                   share(f'{name}: right of those that get a class', right[at & ~known.unknown]),
                   share(f'{name}: objects outside the catalogue called unknown', unlisted.unknown[elsewhere]),
                   share(f'{name}: the same if 90 % of known objects got a class', unlisted.best[elsewhere] < kept)]
        error = expected_calibration_error(known.best[at], right[at])
        print(f'{name}: expected calibration error {100 * error:.1f} %')
        shares.append({'name': f'{name}: expected calibration error', 'share': round(float(error), 4)})
    shares.append(share('false findings called unknown', false))
    counts = confusion(known, of_catalogue)
    print_confusion(counts)
    print(f'{milliseconds(model):.1f} ms a finding on one core')
    if options.json:
        options.json.write_text(json.dumps({'shares': shares, 'labels': LABELS, 'confusion': counts.tolist()}, indent=1) + '\n')


if __name__ == '__main__':
    main()
