// Volumes of bought parts, without their inner details: what the printed parts must fit and keep free.
include <dimensions.scad>

// Axis along +z through the origin, face of the case at z = 0, the case extends towards -y.
module servo() {
  translate([0, servo_axis_to_end - servo_size.y / 2, -servo_size.z / 2]) cube(servo_size, center = true);
  cylinder(d = servo_horn_diameter / 2, h = servo_horn_top - 3, $fn = 32);
  translate([0, 0, servo_horn_top - 3]) cylinder(d = servo_horn_diameter, h = 3, $fn = 48);
}

module bearing(size) {
  difference() {
    cylinder(d = size[1], h = size[2], $fn = 96);
    translate([0, 0, -1]) cylinder(d = size[0], h = size[2] + 2, $fn = 96);
  }
}

// The imager at the origin, x right, y along the view, z up.
module camera_body(c) {
  translate([c[4] - c[0] / 2, c[3] - c[2], -c[1] / 2])
    translate([0, c[2], 0]) rotate([90, 0, 0]) linear_extrude(c[2]) {
      r = min(c[1] / 2 - 0.5, 10);
      translate([r, r]) offset(r, $fn = 48) square([c[0] - 2 * r, c[1] - 2 * r]);
    }
}

module camera_plug(c) {
  translate([c[4] + c[5] * (c[0] / 2 + plug_length / 2), -c[11], 0])
    cube([plug_length, c[12], c[13]], center = true);
}

module led() {  // dome towards +y, its collar at y = 0
  r = led_diameter / 2;
  rotate([-90, 0, 0]) rotate_extrude($fn = 16)
    polygon(concat([[0, -1], [r + 0.4, -1], [r + 0.4, 0], [r, 0], [r, 5.2]],
                   [for (a = [15 : 15 : 75]) [r * cos(a), 5.2 + r * sin(a)]], [[0, 5.2 + r]]));
}

module suction_cup() {  // the lip at z = 0, the stud upwards
  cylinder(d1 = cup_diameter, d2 = 20, h = foot_clearance - 4, $fn = 48);
  translate([0, 0, foot_clearance - 4]) cylinder(d = 20, h = 4, $fn = 48);
  translate([0, 0, foot_clearance]) cylinder(d = 5, h = foot_thickness + 8, $fn = 24);
  translate([0, 0, foot_clearance + foot_thickness]) cylinder(d = 9, h = 5, $fn = 6);
}

module support_foot() {
  cylinder(d = support_diameter, h = 6, $fn = 32);
  translate([0, 0, 6]) cylinder(d = 5, h = foot_clearance + foot_thickness + 2, $fn = 24);
  for (z = [foot_clearance - 4, foot_clearance + foot_thickness]) translate([0, 0, z]) cylinder(d = 9, h = 4, $fn = 6);
}

// A screw along -z, the head's contact at z = 0 for a cylindrical head, its top at z = 0 for a sunk one.
module screw(size, length, sunk) {
  translate([0, 0, -length]) cylinder(d = size, h = length, $fn = 16);
  if (sunk) translate([0, 0, -0.55 * size]) cylinder(d1 = size, d2 = 2 * size, h = 0.55 * size, $fn = 24);
  else cylinder(d = 1.9 * size, h = size, $fn = 24);
}
