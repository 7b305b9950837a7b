"""Checks the folder order of docs/design.md: a folder of src/ includes only itself and folders above it, and no
folder, at any level, includes another in a cycle: detect/ and detect/calibrated/ count as two.

usage: folder_order.py SRC
"""
import pathlib
import re
import sys

ORDER = ['core', 'audit', 'geometry', 'depth', 'capture', 'infrared', 'stereo', 'views', 'measure', 'detect', 'classify', 'plan', 'camera', 'robot', 'doctor', 'map',
         'scene', 'sim', 'inspect', 'report', 'evaluate', 'server', 'store', 'cli']
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def cycle_of(includes):
    """A cycle of folders, as a list that begins and ends with the same one; None where there is none."""
    done, path = set(), []

    def visit(folder):
        if folder in path:
            return [*path[path.index(folder):], folder]
        if folder in done:
            return None
        path.append(folder)
        for included in sorted(includes.get(folder, ())):
            if found := visit(included):
                return found
        done.add(path.pop())
        return None

    return next((found for folder in sorted(includes) if (found := visit(folder))), None)


def main():
    src = pathlib.Path(sys.argv[1])
    faults, includes, within = [], 0, {}
    for folder in sorted(path.name for path in src.iterdir() if path.is_dir()):
        if folder not in ORDER:
            faults.append(f'src/{folder}: not in the order; add it there and to docs/design.md')
    for file in sorted(src.rglob('*.[ch]pp')):
        folder = file.relative_to(src).parts[0]
        own = str(file.parent.relative_to(src))
        for target in INCLUDE.findall(file.read_text()):
            includes += 1
            included = target.split('/')[0]
            if included not in ORDER or not (src / target).exists():
                faults.append(f'{file}: "{target}" is no file of src/')
            elif ORDER.index(included) > ORDER.index(folder):
                faults.append(f'{file}: {folder} may not include {included}')
            other = str(pathlib.PurePosixPath(target).parent)
            if other != own:
                within.setdefault(own, set()).add(other)
    if cycle := cycle_of(within):
        faults.append(f'these folders include each other: {" -> ".join(cycle)}')
    if includes == 0:
        faults.append(f'{src}: no include found, so nothing was held')
    print('\n'.join(faults) or f'{includes} includes keep the order')
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
