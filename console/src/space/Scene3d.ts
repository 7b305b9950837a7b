// The 3D scene that contains the layers: the camera, its control by the user, and drawing only after changes.
import { PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, type Object3D, type Points } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { colorOf } from '../theme';

/** How far from a tap a point of a cloud may be: more than half of the distance between neighbours. */
const reach_m = 0.005;

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
    this.camera.position.copy(center).add(new Vector3(0, -1.35 * radius_m, 0.9 * radius_m));
    this.controls.update();
    this.draw();
  }

  focus(point: Vector3): void {
    const way = this.camera.position.clone().sub(this.controls.target).setLength(0.5);
    this.controls.target.copy(point);
    this.camera.position.copy(point).add(way);
    this.controls.update();
    this.draw();
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
