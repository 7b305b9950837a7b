"""Trains the classifier of findings and writes it with its card.

usage: train.py --data DIR ... --validation DIR ... --out FOLDER [--epochs N] [--seed N] [--resume]

The folders are those of rva_simulated_findings or `rva export-crops`. After each epoch, its state is kept in FOLDER/training.pt, from which
--resume continues. The validation findings set the temperature; they are never trained on.
"""
import argparse
import hashlib
import json
import math
import pathlib

import numpy as np
import torch
from torch import nn

from calibration import fitted_calibration
from findings import BLUE, INFRARED, LABELS, PLANES, PLANE_PX, RED, Findings
from network import Network, export

BATCH = 64
OTHERS = 0.1  # assumed share of objects of no class, and of false findings, among those that people find
LEAST_PROBABILITY = 0.5  # a class is stated if it is more probable than not


def turned(planes, generator):
    """Each finding turned by an angle of its own; at the corners, what lies within is mirrored."""
    angles = 2 * math.pi * torch.rand(len(planes), generator=generator)
    cosines, sines, zeros = angles.cos(), angles.sin(), torch.zeros(len(planes))
    ways = torch.stack([torch.stack([cosines, -sines, zeros], 1), torch.stack([sines, cosines, zeros], 1)], 1)
    grid = nn.functional.affine_grid(ways, planes.shape, align_corners=False)
    return nn.functional.grid_sample(planes, grid, mode='bilinear', padding_mode='reflection', align_corners=False)


def varied(planes, generator):
    """Mirrored, turned, shifted, brighter or darker, and sometimes without a picture."""
    count = len(planes)
    chance = lambda *shape: torch.rand(*shape, generator=generator)
    mirror = chance(count) < 0.5
    planes[mirror] = planes[mirror].flip(3)
    mirror = chance(count) < 0.5
    planes[mirror] = planes[mirror].flip(2)
    turn = chance(count) < 0.5
    planes[turn] = turned(planes[turn], generator)
    across, down = (int(torch.randint(-3, 4, (1,), generator=generator)) for _ in range(2))
    planes = planes.roll((down, across), dims=(2, 3))
    gain = (0.7 + 0.6 * chance(count, 1, 1, 1)) * (0.9 + 0.2 * chance(count, 3, 1, 1))
    planes[:, RED:BLUE + 1] = (planes[:, RED:BLUE + 1] * gain).clamp(0, 1)
    planes[chance(count) < 0.1, RED:INFRARED + 1] = 0
    return planes


def batches(findings, generator, size=BATCH):
    order = torch.randperm(len(findings), generator=generator).numpy()
    for start in range(0, len(order), size):
        chosen = np.sort(order[start:start + size])
        planes = torch.from_numpy(findings.planes[chosen].astype(np.float32))
        yield planes, torch.from_numpy(findings.labels[chosen])


def weights_of(labels):
    """Rare classes count more, by the root of their rarity."""
    counts = np.bincount(labels, minlength=len(LABELS) + 1).astype(float)
    weights = 1 / np.sqrt(np.maximum(counts, 1))
    return torch.tensor(weights / weights.mean(), dtype=torch.float32)


def learning_rate(progress):
    """Rises over the first tenth of the training, then falls as a cosine."""
    greatest, rise = 2e-3, 0.1
    if progress < rise:
        return greatest * progress / rise
    return greatest * 0.5 * (1 + math.cos(math.pi * (progress - rise) / (1 - rise)))


def outputs_of(network, findings):
    network.eval()
    parts = []
    with torch.no_grad():
        for start in range(0, len(findings), BATCH):
            planes = torch.from_numpy(findings.planes[start:start + BATCH].astype(np.float32))
            parts.append(network(planes).numpy())
    return np.concatenate(parts)


def train(network, findings, validation, options):
    generator = torch.Generator().manual_seed(options.seed)
    optimizer = torch.optim.AdamW(network.parameters(), weight_decay=1e-2)
    loss_of = nn.CrossEntropyLoss(weight=weights_of(findings.labels))
    kept, first = options.out / 'training.pt', 0
    if options.resume and kept.exists():
        state = torch.load(kept)
        network.load_state_dict(state['network'])
        optimizer.load_state_dict(state['optimizer'])
        generator.set_state(state['generator'])
        first = state['epoch']
    for epoch in range(first, options.epochs):
        network.train()
        losses = []
        for group in optimizer.param_groups:
            group['lr'] = learning_rate((epoch + 0.5) / options.epochs)
        for planes, labels in batches(findings, generator):
            loss = loss_of(network(varied(planes, generator)), labels)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            losses.append(loss.item())
        known = validation.labels < len(LABELS)
        right = outputs_of(network, validation)[:, :-1].argmax(1) == validation.labels
        print(f'epoch {epoch + 1}: loss {np.mean(losses):.3f}, right of known in validation {right[known].mean():.3f}',
              flush=True)
        torch.save({'network': network.state_dict(), 'optimizer': optimizer.state_dict(),
                    'generator': generator.get_state(), 'epoch': epoch + 1}, kept)


def write_card(network, validation, out):
    outputs = outputs_of(network, validation)
    temperature, of_others = fitted_calibration(outputs, validation.labels, OTHERS)
    with torch.no_grad():
        network.outputs.bias[-1] += of_others
    export(network, out / 'findings.onnx')
    card = {'format': 'rva-finding-model', 'version': 1, 'model': 'findings.onnx',
            'sha256': hashlib.sha256((out / 'findings.onnx').read_bytes()).hexdigest(),
            'planes': PLANES, 'plane_px': PLANE_PX, 'labels': LABELS, 'temperature': round(temperature, 4),
            'others': OTHERS, 'least_probability': LEAST_PROBABILITY}
    (out / 'findings.json').write_text(json.dumps(card, indent=1) + '\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--data', nargs='+', required=True)
    parser.add_argument('--validation', nargs='+', required=True)
    parser.add_argument('--out', type=pathlib.Path, required=True)
    parser.add_argument('--epochs', type=int, default=30)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--resume', action='store_true')
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    torch.manual_seed(options.seed)
    findings, validation = Findings(options.data), Findings(options.validation)
    print(f'{len(findings)} findings to train on, {len(validation)} to validate')
    network = Network()
    train(network, findings, validation, options)
    write_card(network, validation, options.out)


if __name__ == '__main__':
    main()
