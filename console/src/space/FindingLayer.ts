// The findings in the map, each with a ring and a number.
import { CanvasTexture, Group, Sprite, SpriteMaterial } from 'three';
import { signOf } from '../inspection/words';
import type { Group as FindingGroup } from '../review/groups';
import { colorOf } from '../theme';
import type { FindingKind } from '../types';

const size_px = 128;

function picture(number: number, kind: FindingKind, selected: boolean): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size_px;
  const draw = canvas.getContext('2d');
  if (draw) {
    const middle = size_px / 2;
    draw.lineWidth = selected ? 16 : 10;
    draw.strokeStyle = colorOf(`--mark-${kind}`);
    draw.fillStyle = colorOf('--picture-shade');
    draw.beginPath();
    draw.arc(middle, middle, middle - 12, 0, 2 * Math.PI);
    draw.fill();
    draw.stroke();
    draw.fillStyle = colorOf('--mark');
    draw.font = 'bold 52px sans-serif';
    draw.textAlign = 'center';
    draw.textBaseline = 'middle';
    draw.fillText(`${number}${signOf({ kind })}`, middle, middle + 3);
  }
  return new CanvasTexture(canvas);
}

export class FindingLayer {
  readonly group = new Group();

  set(groups: FindingGroup[], selected: number): void {
    this.dispose();
    for (const { label, lead } of groups) {
      if (!lead.in_foot_m) continue;
      const material = new SpriteMaterial({ map: picture(label, lead.kind, lead.number === selected), depthTest: false, sizeAttenuation: false });
      const sprite = new Sprite(material);
      const scale = lead.number === selected ? 0.075 : 0.055;
      sprite.scale.set(scale, scale, 1);
      sprite.position.set(...lead.in_foot_m);
      sprite.userData['number'] = lead.number;
      this.group.add(sprite);
    }
  }

  dispose(): void {
    for (const child of [...this.group.children]) {
      if (child instanceof Sprite) {
        child.material.map?.dispose();
        child.material.dispose();
      }
      this.group.remove(child);
    }
  }
}
