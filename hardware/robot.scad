// One part or the whole robot. openscad -D 'part="hub"' robot.scad; part="list" prints what there is as JSON.
include <parts.scad>
use <bought.scad>
part = "list";

// name, group that it moves with, "printed" or "bought", and for printed parts the turn from the robot's frame to
// the print bed (degrees about x, y, z).
parts = [
  ["foot", "fixed", "printed", [0, 0, 0]], ["tether_clamp", "fixed", "printed", [180, 0, 0]],
  ["release_lever", "fixed", "printed", [0, 90, 0]],
  ["column", "fixed", "printed", [0, 0, 0]], ["pan_housing", "fixed", "printed", [0, 0, 0]],
  ["outer_spacer", "fixed", "printed", [0, 0, 0]], ["retaining_ring", "fixed", "printed", [0, 0, 0]],
  ["pan_cradle", "fixed", "printed", [0, 0, 0]], ["hub", "pan", "printed", [0, 0, 0]],
  ["yoke_floor", "pan", "printed", [180, 0, 0]], ["servo_arm", "pan", "printed", [0, -90, 0]],
  ["tilt_cradle", "pan", "printed", [0, -90, 0]], ["pivot_arm", "pan", "printed", [0, -90, 0]],
  ["camera_bracket", "tilt", "printed", [90, 0, 0]], ["led_frame", "tilt", "printed", [90, 0, 0]],
  ["suction_cups", "fixed", "bought", undef], ["support_feet", "fixed", "bought", undef], ["cables", "fixed", "bought", undef],
  ["pan_servo", "fixed", "bought", undef], ["pan_bearings", "fixed", "bought", undef],
  ["tilt_servo", "pan", "bought", undef], ["tilt_bearing", "pan", "bought", undef],
  ["camera", "tilt", "bought", undef], ["plug", "tilt", "bought", undef], ["leds", "tilt", "bought", undef]];

// Screws: name, thread, length, sunk, position and direction of the head in the robot's frame, group.
screws = concat(
  [for (p = posts) ["foot to column", 3, 16, true, [p.x, p.y, foot_z], [0, 0, -1]]],
  [for (p = posts) ["ring to column", 3, 40, true, [p.x, p.y, ring_z + ring_thickness], [0, 0, 1]]],
  [for (p = ring_screws) ["ring to housing", 3, 8, true, [p.x, p.y, ring_z + ring_thickness], [0, 0, 1]]],
  [for (p = cradle_screws) ["housing to pan cradle", 3, 10, true, [p.x, p.y, servo_z + floor_thickness], [0, 0, 1]]],
  [for (p = horn_screws) ["hub to pan horn", 2, 8, false, [p.x, p.y, hub_z + floor_thickness], [0, 0, 1]]],
  [for (p = hub_screws) ["yoke to hub", 3, 20, true, [p.x, p.y, servo1_z + yoke_thickness], [0, 0, 1]]],
  [for (y = arm_screws) ["servo arm to yoke", 3, 12, false, [tilt_servo_x, y, servo1_z + yoke_thickness / 2], [-1, 0, 0]]],
  [for (y = arm_screws) ["pivot arm to yoke", 3, 16, false, [pivot_arm_x + pivot_arm, y, servo1_z + yoke_thickness / 2], [1, 0, 0]]],
  [for (p = cradle_screws) ["arm to tilt cradle", 3, 10, true, [servo_arm_x, p.x, tilt_axis_z + p.y], [1, 0, 0]]],
  [for (p = horn_screws) ["bracket to tilt horn", 2, 8, false, [servo_ear_x, p.x, tilt_axis_z + p.y], [1, 0, 0]]],
  [["pivot", 5, 16, false, [pivot_arm_x + pivot_arm, 0, tilt_axis_z], [1, 0, 0]]],
  [for (x = [-cam[6] / 2, cam[6] / 2]) ["bracket to camera", cam[10], camera_screw, false, [x, max(camera_back_y - camera_screw_seat, bracket_back), tilt_axis_z + imager_z], [0, -1, 0]]],
  [for (p = led_posts) ["LED frame to bracket", 3, 12, true, [p.x, frame_y + led_frame_y, tilt_axis_z + p.y], [0, 1, 0]]],
  [for (p = clamp_screws) ["clamp to foot", 3, 16, false, [p.x, p.y, column_z + clamp_z + 8.5], [0, 0, 1]]],
  [["lever pivot", 3, 30, false, [-lever_width / 2 - 6.75, lever_pivot.x, lever_pivot.y], [-1, 0, 0]]]);

module at_screw(s) {
  d = s[5];
  translate(s[4]) rotate(d.z == 1 ? [0, 0, 0] : d.z == -1 ? [180, 0, 0] : d.x != 0 ? [0, 90 * d.x, 0] : [-90 * d.y, 0, 0]) children();
}

module cables() {
  for (s = [-1, 1]) translate([s * clamp_x, -150, column_z + clamp_z]) rotate([-90, 0, 0])
    cylinder(d = s > 0 ? usb_cable : power_cable, h = 150 - column_rear + 10, $fn = 32);
}

module named_part(name) {
  if (name == "foot") foot();
  if (name == "tether_clamp") tether_clamp();
  if (name == "release_lever") release_lever();
  if (name == "column") column();
  if (name == "pan_housing") pan_housing();
  if (name == "outer_spacer") outer_spacer();
  if (name == "retaining_ring") retaining_ring();
  if (name == "pan_cradle") translate([0, 0, servo_z]) servo_cradle();
  if (name == "hub") hub();
  if (name == "yoke_floor") yoke_floor();
  if (name == "servo_arm") servo_arm();
  if (name == "tilt_cradle") as_tilt_servo() servo_cradle();
  if (name == "pivot_arm") pivot_arm();
  if (name == "camera_bracket") camera_bracket();
  if (name == "led_frame") led_frame();
  if (name == "suction_cups") for (x = [-cup_at, cup_at], y = [-cup_at, cup_at]) translate([x, y, 0]) suction_cup();
  if (name == "support_feet") for (p = supports) translate(p) support_foot();
  if (name == "cables") cables();
  if (name == "pan_servo") translate([0, 0, servo_z]) servo();
  if (name == "pan_bearings") for (z = bearings_z) translate([0, 0, z]) bearing(pan_bearing);
  if (name == "tilt_servo") as_tilt_servo() servo();
  if (name == "tilt_bearing") translate([pivot_arm_x + pivot_arm - tilt_bearing[2], 0, tilt_axis_z])
    rotate([0, 90, 0]) bearing(tilt_bearing);
  if (name == "camera") on_tilt_axis() translate([-cam[4], imager_y, imager_z]) camera_body(cam);
  if (name == "plug") on_tilt_axis() translate([-cam[4], imager_y, imager_z]) camera_plug(cam);
  if (name == "leds") on_tilt_axis() for (p = leds) translate([p.x, frame_y, p.y]) led();
}

if (part == "list") {
  for (p = parts) echo(part = p);
  for (s = screws) echo(screw = s);
  echo(chain = [servo1_z, tilt_z, -cam[4], imager_y, imager_z]);
} else {
  named_part(part);
}
