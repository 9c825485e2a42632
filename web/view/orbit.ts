import { Spherical, Vector3, type PerspectiveCamera } from 'three';
import type { Vector } from '../model/vector.js';
import type { Extent } from './model-geometry.js';
import type { Turn } from './model-message.js';

/** The first point of view: how far from the middle of the unit sphere, and how high. */
const distance = 3.6;
export const viewHeight = 0.37;
const sideways = 0.65;

/** Outside of the model, and not so far that it is lost. */
const [nearest, farthest] = [1.4, 8];

/** Nearer to straight from above or below, left and right would turn over; radians. */
const steepest = 0.25;

/** Room around the model, as a share of its size. */
const air = 1.1;

/** Keeps a camera looking at the model and moves it around. */
export class Orbit {
  private extent: Extent = { up: 1, reach: 1, near: 0, deep: false };
  private shape = 1;

  constructor(private readonly camera: PerspectiveCamera) {}

  /** Back to the first view, of a model of this extent: on its long side, a little from above. */
  reset(extent: Extent): void {
    this.extent = extent;
    const around = extent.deep ? Math.PI / 2 - sideways : sideways;
    this.place(new Spherical(distance, Math.PI / 2 - viewHeight, around));
    this.fit(this.shape);
  }

  /** Width over height of the view. */
  get aspect(): number {
    return this.shape;
  }

  /** Lets the model fill a view of this shape, from whichever side it is seen. */
  fit(aspect: number): void {
    this.shape = aspect;
    const { up, reach, near } = this.extent;
    // What is nearer than the middle looks larger.
    const half = Math.max(up, reach / aspect) / (distance - near);
    this.camera.aspect = aspect;
    this.camera.fov = (2 * Math.atan(air * half) * 180) / Math.PI;
    this.camera.updateProjectionMatrix();
  }

  /** Lets something of another extent fill the view, from where it is seen now. */
  frame(extent: Extent): void {
    this.extent = extent;
    this.fit(this.shape);
  }

  /** From where it is seen now, as an angle in radians around the upright axis. */
  get around(): number {
    return new Spherical().setFromVector3(this.camera.position).theta;
  }

  /** The same above the horizon. */
  get height(): number {
    return Math.PI / 2 - new Spherical().setFromVector3(this.camera.position).phi;
  }

  /** Looks from this direction at the middle, as far away as now. */
  look([x, y, z]: Vector): void {
    const place = new Spherical().setFromVector3(this.camera.position);
    const { phi, theta } = new Spherical().setFromVector3(new Vector3(x, y, z));
    place.theta = theta;
    place.phi = Math.min(Math.max(phi, steepest), Math.PI - steepest);
    this.place(place);
  }

  turn({ around, down, away }: Turn): void {
    const place = new Spherical().setFromVector3(this.camera.position);
    place.theta += around;
    place.phi += down;
    place.radius = Math.min(Math.max(place.radius * away, nearest), farthest);
    this.place(place.makeSafe());
  }

  private place(place: Spherical): void {
    this.camera.position.setFromSpherical(place);
    this.camera.lookAt(0, 0, 0);
  }
}
