// The points of the map that are measured between, and the line that connects them.
import { BufferGeometry, CanvasTexture, Group, Line, LineBasicMaterial, Sprite, SpriteMaterial, Vector3 } from 'three';
import { colorOf } from '../theme';
import type { Point3 } from '../types';

const size_px = 64;

// A cross in a ring, white with a dark edge, visible over everything.
function cross(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size_px;
  const draw = canvas.getContext('2d');
  const middle = size_px / 2;
  for (const [style, width] of [['--mark-halo', 10], ['--mark', 5]] as const) {
    if (!draw) break;
    draw.strokeStyle = colorOf(style);
    draw.lineWidth = width;
    draw.beginPath();
    draw.arc(middle, middle, 14, 0, 2 * Math.PI);
    draw.moveTo(6, middle);
    draw.lineTo(size_px - 6, middle);
    draw.moveTo(middle, 6);
    draw.lineTo(middle, size_px - 6);
    draw.stroke();
  }
  return new CanvasTexture(canvas);
}

export class MeasureLayer {
  readonly group = new Group();
  private readonly material = new SpriteMaterial({ map: cross(), depthTest: false, sizeAttenuation: false });
  private readonly ink = new LineBasicMaterial({ color: colorOf('--mark'), depthTest: false });

  set(points_m: Point3[]): void {
    this.clear();
    for (const at of points_m) {
      const sprite = new Sprite(this.material);
      sprite.scale.set(0.05, 0.05, 1);
      sprite.position.set(...at);
      this.group.add(sprite);
    }
    if (points_m.length === 2) this.group.add(new Line(new BufferGeometry().setFromPoints(points_m.map((at) => new Vector3(...at))), this.ink));
  }

  private clear(): void {
    for (const child of [...this.group.children]) {
      if (child instanceof Line) child.geometry.dispose();
      this.group.remove(child);
    }
  }

  dispose(): void {
    this.clear();
    this.material.map?.dispose();
    this.material.dispose();
    this.ink.dispose();
  }
}
