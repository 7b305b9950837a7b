// A part without what is to the right of the pan axis ("x") or in front of the tilt axis ("y"), for section views.
folder = "";
name = "";
plane = "x";
difference() {
  import(str(folder, "/", name, ".stl"));
  translate(plane == "x" ? [0.01, -500, -10] : [-500, 0.01, -10]) cube(1000);
}
