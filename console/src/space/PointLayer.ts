// The map's points, coloured by colour, by height, or with the changes.
import { BufferAttribute, BufferGeometry, Color, Points, PointsMaterial, Vector3 } from 'three';
import { PLYLoader } from 'three/examples/jsm/loaders/PLYLoader.js';
import { middle, reach_m, shuffled } from './point_sample';

export type Coloring = 'color' | 'height' | 'change';

/** While the view turns, no more points than this are drawn; at rest, all. */
const most_while_moving = 400_000;

export class PointLayer {
  readonly points: Points<BufferGeometry, PointsMaterial>;
  readonly count: number;
  readonly center = new Vector3();
  readonly radius_m: number;
  private readonly original: BufferAttribute;

  constructor(ply: ArrayBuffer, size_m = 0.004) {
    const geometry = new PLYLoader().parse(ply);
    const positions = geometry.getAttribute('position');
    this.count = positions.count;
    const order = shuffled(this.count);
    const xyz = new Float32Array(3 * this.count);
    const rgb = new Float32Array(3 * this.count);
    const colors = geometry.getAttribute('color');
    order.forEach((from, to) => {
      xyz.set([positions.getX(from), positions.getY(from), positions.getZ(from)], 3 * to);
      rgb.set(colors ? [colors.getX(from), colors.getY(from), colors.getZ(from)] : [0.6, 0.6, 0.6], 3 * to);
    });
    const ordered = new BufferGeometry();
    ordered.setAttribute('position', new BufferAttribute(xyz, 3));
    this.original = new BufferAttribute(rgb, 3);
    ordered.setAttribute('color', this.original);
    ordered.computeBoundingSphere();
    this.center.set(middle(xyz, 0), middle(xyz, 1), middle(xyz, 2));
    this.radius_m = reach_m(xyz, this.center.toArray());
    this.points = new Points(ordered, new PointsMaterial({ size: size_m, vertexColors: true }));
    geometry.dispose();
  }

  setMoving(moving: boolean): void {
    this.points.geometry.setDrawRange(0, moving ? Math.min(this.count, most_while_moving) : this.count);
  }

  setColoring(coloring: Coloring): void {
    this.points.geometry.setAttribute('color', coloring === 'color' ? this.original : this.colored(coloring));
  }

  private colored(coloring: Coloring): BufferAttribute {
    const xyz = this.points.geometry.getAttribute('position');
    const rgb = new Float32Array(3 * this.count);
    const color = new Color();
    const box = this.points.geometry.boundingBox ?? (this.points.geometry.computeBoundingBox(), this.points.geometry.boundingBox!);
    const height = Math.max(1e-3, box.max.z - box.min.z);
    for (let i = 0; i < this.count; ++i) {
      if (coloring === 'height') {
        color.setHSL(0.66 * (1 - (xyz.getZ(i) - box.min.z) / height), 0.85, 0.55);
      } else {
        const brightness = (this.original.getX(i) + this.original.getY(i) + this.original.getZ(i)) / 3;
        color.setScalar(0.08 + 0.5 * brightness);
      }
      rgb.set([color.r, color.g, color.b], 3 * i);
    }
    return new BufferAttribute(rgb, 3);
  }

  dispose(): void {
    this.points.geometry.dispose();
    this.points.material.dispose();
  }
}
