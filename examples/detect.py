"""Compares two captures and prints what changed: detect.py BEFORE AFTER"""
import sys

import rva


def described(finding: rva.Finding) -> str:
    size = 'of unknown size' if finding.size_mm is None else f'{finding.size_mm[0]:.0f} x {finding.size_mm[1]:.0f} mm'
    return f'{finding.kind} {size}, {finding.area_px} px, box {finding.box}'


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        result = rva.detect(sys.argv[1], sys.argv[2])
    except rva.Error as error:
        print(f'detect: {error}', file=sys.stderr)
        return 1
    for finding in result:
        print(described(finding))
    changed = result.changed  # an array of numpy that shows the result's own pixels
    print(f'{100 * (changed != 0).mean():.2f} % of the pixels changed')
    return 0


if __name__ == '__main__':
    sys.exit(main())
