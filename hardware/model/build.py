"""Writes STL files, robot-geometry.json, the bill of materials, the wiring plan, figures and pictures into a folder.

usage: build.py FOLDER [--camera NAME] [--no-pictures] [--documents]
--documents also renews the generated files beside the model: the bill of materials, the wiring plan, the pictures.
"""
import argparse
import json
import pathlib
import shutil
import sys

import bill
import collision
import passage
import pictures
import robot as model
from mesh import write_stl
from printing import on_bed
from statics import Statics
from wiring import Plan

HOLES_MM = {'ellipse 254 x 457': (254, 457), 'circle 230': (230, 230)}


def figures(robot):
    """What is computed from the meshes, for people and the test."""
    dimensions, materials = model.dimensions(), bill.rows()
    statics = Statics(robot, dimensions, bill.masses_g(materials, dimensions))
    outline = passage.silhouette(robot)
    leds = next(row['quantity'] for row in materials if row['model'] == 'leds')
    return {'camera': robot.camera,
            'mass_g': statics.body('fixed', 'pan', 'tilt')[0] * 1000 + bill.unmodelled_g(materials),
            'pan': statics.joint('pan'), 'tilt': statics.joint('tilt'), 'foot': statics.foot(), 'tipping': statics.tipping(),
            'release': statics.release(), 'play': statics.play(), 'supply': statics.supply(leds),
            'clearance_mm': {name: passage.clearance(outline, *size) for name, size in HOLES_MM.items()},
            'self_view_deg': collision.first_self_view(robot, statics.d[f'camera_{robot.camera}'][8:10]),
            'price_usd': bill.price_usd(materials), 'screws': len(robot.screws)}


def figure_table(found):
    """The table of README.md."""
    rows = [('mass with tether inside, printed parts solid', f"{found['mass_g']:.0f} g"),
            ('largest torque on the pan servo, and its stall torque over it', f"{found['pan']['total_nm']:.3f} N m, {found['pan']['margin']:.1f}"),
            ('largest torque on the tilt servo, and its stall torque over it', f"{found['tilt']['total_nm']:.3f} N m, {found['tilt']['margin']:.1f}"),
            *((f'room all around in a hole, {name} mm', f'{value:.0f} mm') for name, value in found['clearance_mm'].items()),
            ('tilt below which the depth image shows the robot itself', f"{found['self_view_deg']} degrees"),
            ('foot under 20 N at the tether: deflection, turn of the plate', f"{found['foot']['deflection_mm']:.3f} mm, {found['foot']['slope_deg']:.2f} degrees"),
            ('that turn at the camera', f"{found['foot']['camera_px']:.1f} px"),
            ('pull that slides it, that tips it, cups holding', f"{found['tipping']['slides_n']:.0f} N, {found['tipping']['tips_n']:.0f} N"),
            ('the same without cups', f"{found['tipping']['slides_without_cups_n']:.0f} N, {found['tipping']['tips_without_cups_n']:.0f} N"),
            ('pull on the cord that releases the cups, and lift', f"{found['release']['cord_n']:.0f} N, {found['release']['lift_mm']:.0f} mm"),
            ('play of a servo at the camera; half a servo step', f"{found['play']['servo_play_px']:.1f} px; {found['play']['half_step_px']:.1f} px"),
            ('play of the pan bearings, were they not preloaded', f"{found['play']['bearings_without_preload_px']:.1f} px"),
            ('12 V at the servos, both stalled; 5 V at the receiver', f"{found['supply']['servos_v']:.1f} V; {found['supply']['receiver_v']:.2f} V"),
            ('5 V at the camera, from 5.0 V at the computer', f"{found['supply']['camera_v']:.2f} V"),
            ('price without the computer', f"{found['price_usd']:.0f} USD"), ('screws', f"{found['screws']}")]
    return '\n'.join(['| computed | |', '| --- | --- |', *(f'| {name} | {value} |' for name, value in rows)]) + '\n'


def rounded(value):
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    return round(value, 3) if isinstance(value, float) else value


def write(out, robot, with_pictures=True):
    out.mkdir(parents=True, exist_ok=True)
    model.export(robot, out / 'parts')
    (out / 'print').mkdir(exist_ok=True)
    for part in robot.named('printed'):
        write_stl(out / 'print' / f'{part.name}.stl', on_bed(part.mesh, part.print_turn))
    (out / 'robot-geometry.json').write_text(json.dumps(robot.geometry(), indent=2) + '\n')
    found = figures(robot)
    (out / 'figures.json').write_text(json.dumps(rounded(found), indent=2) + '\n')
    (out / 'figures.md').write_text(figure_table(found))
    (out / 'bill-of-materials.md').write_text(bill.page(bill.rows(), robot))
    (out / 'wiring.svg').write_text(Plan((model.HARDWARE / 'wiring.txt').read_text()).svg())
    if with_pictures:
        pictures.write(out / 'parts', out / 'images', robot)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('--camera', choices=model.CAMERAS, default='D435')
    parser.add_argument('--no-pictures', action='store_true')
    parser.add_argument('--documents', action='store_true')
    options = parser.parse_args()
    if not model.openscad():
        sys.exit('hardware: openscad is missing; script/bootstrap --all installs it')
    robot = model.Robot(options.camera)
    write(options.folder, robot, not options.no_pictures)
    if options.documents:
        for name in ('bill-of-materials.md', 'wiring.svg'):
            shutil.copy(options.folder / name, model.HARDWARE / name)
        if not options.no_pictures:
            shutil.copytree(options.folder / 'images', model.HARDWARE / 'images', dirs_exist_ok=True)
    print(options.folder.resolve())


if __name__ == '__main__':
    main()
