// The 3D scene that contains the layers: the camera, its control by the user, and drawing only after changes.
import { PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, type Object3D, type Points } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { colorOf } from '../theme';
import { brought, turned, type Xyz } from './orbit';

/** How far from a tap a point of a cloud may be: more than half of the distance between neighbours. */
const reach_m = 0.005;
/** How far a key turns and moves the camera, and between which distances it brings it. */
const turn_rad = Math.PI / 36;
const move_share = 0.1;
const reaches_m: [number, number] = [0.02, 50];

export class Scene3d {
  onMoving: (moving: boolean) => void = () => undefined;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(55, 1, 0.01, 100);
  private readonly renderer: WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly resized: ResizeObserver;
  private wanted = 0;

  constructor(private readonly box: HTMLElement) {
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(colorOf('--picture-ground'));
    box.append(this.renderer.domElement);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => this.onMoving(true));
    this.controls.addEventListener('end', () => {
      this.onMoving(false);
      this.draw();
    });
    this.resized = new ResizeObserver(() => this.fit());
    this.resized.observe(box);
    this.fit();
  }

  add(object: Object3D): void {
    this.scene.add(object);
    this.draw();
  }

  remove(object: Object3D): void {
    this.scene.remove(object);
  }

  /** Views the bay as the robot does: along y, a little from above. */
  lookAt(center: Vector3, radius_m: number): void {
    this.controls.target.copy(center);
    this.place([0, -1.35 * radius_m, 0.9 * radius_m]);
  }

  /** Turns the camera about what is in the middle. @param right in steps, as `up` */
  turn(right: number, up: number): void {
    this.place(turned(this.fromTarget(), -right * turn_rad, up * turn_rad));
  }

  /** Moves the camera together with what is in the middle. @param right in steps, as `up` */
  move(right: number, up: number): void {
    const far_m = move_share * Math.hypot(...this.fromTarget());
    const way = new Vector3(right, up, 0).multiplyScalar(far_m).applyQuaternion(this.camera.quaternion);
    this.controls.target.add(way);
    this.camera.position.add(way);
    this.redraw();
  }

  /** @param times the distance of the camera from what is in the middle, over that of before */
  zoom(times: number): void {
    this.place(brought(this.fromTarget(), times, reaches_m));
  }

  private fromTarget(): Xyz {
    return this.camera.position.clone().sub(this.controls.target).toArray();
  }

  private place(from_target: Xyz): void {
    this.camera.position.copy(this.controls.target).add(new Vector3(...from_target));
    this.redraw();
  }

  private redraw(): void {
    this.controls.update();
    this.draw();
  }

  focus(point: Vector3): void {
    const way = this.camera.position.clone().sub(this.controls.target).setLength(0.5);
    this.controls.target.copy(point);
    this.place(way.toArray());
  }

  /** The nearest of the objects under a point of the page, or null. */
  pick(event: { clientX: number; clientY: number }, objects: Object3D[]): Object3D | null {
    return this.rayAt(event).intersectObjects(objects, false)[0]?.object ?? null;
  }

  /** The point of a cloud under a point of the page, by default in the middle; null where there is none. */
  pickPoint(cloud: Points, event?: { clientX: number; clientY: number }): Vector3 | null {
    const ray = this.rayAt(event);
    ray.params.Points.threshold = reach_m;
    const { index } = ray.intersectObject(cloud, false)[0] ?? {};
    const positions = cloud.geometry.getAttribute('position');
    return index === undefined ? null : new Vector3().fromBufferAttribute(positions, index);
  }

  private rayAt(event?: { clientX: number; clientY: number }): Raycaster {
    const box = this.renderer.domElement.getBoundingClientRect();
    const at = event ? new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2) : new Vector2(0, 0);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray;
  }

  draw(): void {
    if (this.wanted) return;
    this.wanted = requestAnimationFrame(() => {
      this.wanted = 0;
      this.renderer.render(this.scene, this.camera);
    });
  }

  dispose(): void {
    cancelAnimationFrame(this.wanted);
    this.resized.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.domElement.remove();
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }
}
