import { Spherical, type PerspectiveCamera } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Extent } from './model-geometry.js';

/** Angle of one press of a key in radians, and how much nearer one press of + comes. */
const keyAngle = Math.PI / 24;
const keyZoom = 0.9;

/** The first point of view: how far from the middle of the unit sphere, and how high. */
const distance = 3.6;
export const viewHeight = 0.37;
const sideways = 0.65;

/** Room around the model, as a share of its size. */
const air = 1.1;

/** Turns the camera around the model: by pointer, by touch, by keys and by itself. */
export class Orbit {
  private readonly controls: OrbitControls;
  private extent: Extent = { up: 1, reach: 1, deep: false };
  private aspect = 1;

  constructor(
    private readonly camera: PerspectiveCamera,
    canvas: HTMLCanvasElement,
    private readonly onChange: () => void,
    onGrab: () => void,
  ) {
    this.controls = new OrbitControls(camera, canvas);
    this.controls.enablePan = false;
    this.controls.minDistance = 1.4;
    this.controls.maxDistance = 8;
    // The wheel belongs to the page until the model has been chosen, and so does a finger's way up.
    this.controls.enableZoom = false;
    canvas.style.touchAction = 'pan-y';
    canvas.addEventListener('focus', () => (this.controls.enableZoom = true));
    canvas.addEventListener('blur', () => (this.controls.enableZoom = false));
    canvas.addEventListener('pointerdown', () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener('keydown', (event) => this.press(event, onGrab));
    this.controls.addEventListener('change', onChange);
    this.controls.addEventListener('start', onGrab);
  }

  /** Back to the first view, of a model of this extent: on its long side, a little from above. */
  reset(extent: Extent): void {
    this.extent = extent;
    const around = extent.deep ? Math.PI / 2 - sideways : sideways;
    this.camera.position.setFromSphericalCoords(distance, Math.PI / 2 - viewHeight, around);
    this.controls.update();
    this.fit(this.aspect);
  }

  /** Lets the model fill a view of this shape, from whichever side it is seen. */
  fit(aspect: number): void {
    this.aspect = aspect;
    const { up, reach } = this.extent;
    // What is nearer than the middle looks larger; little of a model is at its very front.
    const half = Math.max(up, reach / aspect) / (distance - reach / 3);
    this.camera.aspect = aspect;
    this.camera.fov = (2 * Math.atan(air * half) * 180) / Math.PI;
    this.camera.updateProjectionMatrix();
  }

  /** Turns by angles in radians, and moves away by a factor. */
  turn(around: number, down = 0, away = 1): void {
    const place = new Spherical().setFromVector3(this.camera.position);
    place.theta += around;
    place.phi += down;
    place.radius *= away;
    place.makeSafe();
    this.camera.position.setFromSpherical(place);
    this.controls.update();
    this.onChange();
  }

  private press(event: KeyboardEvent, onGrab: () => void): void {
    const turns: Record<string, [number, number, number]> = {
      ArrowLeft: [-keyAngle, 0, 1],
      ArrowRight: [keyAngle, 0, 1],
      ArrowUp: [0, -keyAngle, 1],
      ArrowDown: [0, keyAngle, 1],
      '+': [0, 0, keyZoom],
      '-': [0, 0, 1 / keyZoom],
    };
    const turn = turns[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    onGrab();
    this.turn(...turn);
  }
}
