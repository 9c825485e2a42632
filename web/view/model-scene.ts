import {
  DirectionalLight,
  HemisphereLight,
  PerspectiveCamera,
  Raycaster,
  Scene,
  Vector2,
} from 'three';
import { Brush } from './brush.js';
import type { PictureSize } from './picture-size.js';
import type { CanvasMessage, DrawerListener } from './drawing.js';
import { FoldingStage } from './folding-stage.js';
import { extentOf } from './model-geometry.js';
import { ModelLights } from './model-lights.js';
import { ModelLooks } from './model-looks.js';
import { ModelMesh } from './model-mesh.js';
import type { Folding, ModelAnswer, ModelMessage } from './model-message.js';
import type { ModelScreen } from './model-screen.js';
import { Orbit, viewHeight } from './orbit.js';
import { Redraw } from './redraw.js';

/** Radians per second of the slow turn, and ms between two of its steps. */
const turnSpeed = 0.25;
const turnInterval = 33;

/** A model in 3D, lit, flat-shaded and coloured by part; draws in frames, and only what changed. */
export class ModelScene {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera();
  private readonly orbit = new Orbit(this.camera);
  private readonly mesh = new ModelMesh();
  private readonly lights = new ModelLights();
  private readonly stepLights = new ModelLights();
  private readonly brush = new Brush({
    faceAt: (x, y) => this.faceAt(x, y),
    partOf: (face) => this.mesh.partOf(face),
    paint: (face, part) => this.mesh.give(face, part),
  });
  private readonly redraw = new Redraw(() => this.guard(() => this.draw()));
  private readonly looks = new ModelLooks(this.mesh, () => this.redraw.request());
  private folding: Folding | null = null;
  /** Made when it is first needed: most results are only looked at. */
  private stage: FoldingStage | null = null;
  /** How far the pieces are, and how far they are to be. */
  private time = 1;
  private wantedTime = 1;
  /** Whether the pieces were turned since they moved. */
  private isTurned = false;
  private visible = false;
  private turning = false;
  private lastTurn = -Infinity;

  /** @param listener hears which face is seen where someone points */
  constructor(
    private readonly screen: ModelScreen,
    private readonly listener: DrawerListener<ModelAnswer>,
  ) {
    const sun = new DirectionalLight('#fff6e6', 2.1);
    sun.position.set(-0.7, 1, 0.9);
    // The light stays at the beholder's shoulder, so that no side is ever dark.
    this.camera.add(sun, sun.target);
    this.scene.add(this.camera, new HemisphereLight('#ffffff', '#b8a98c', 1.5));
    this.scene.add(this.mesh.group, this.lights.group, this.stepLights.group);
    screen.prepare(this.scene, this.camera);
    screen.onRestored(() => this.redraw.request());
  }

  take(message: ModelMessage | CanvasMessage): void {
    this.guard(() => this.obey(message));
  }

  /** Ends the scene with what fails in it: others may share its thread, and go on. */
  private guard(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.end();
      this.listener.fail(error);
    }
  }

  private obey(message: ModelMessage | CanvasMessage): void {
    switch (message.type) {
      case 'model':
        this.show(message);
        break;
      case 'labels':
        this.mesh.paint(message.labels);
        break;
      case 'selected':
        this.mesh.select(message.parts);
        break;
      case 'lights':
        this.light(message);
        break;
      case 'step':
        this.stepLights.show(message.edges, message.kinds);
        break;
      case 'point':
        this.pick(message);
        return;
      case 'stroke':
        this.stroke(message);
        break;
      case 'lit':
        this.mesh.light(message.faces);
        break;
      case 'hatched':
        this.mesh.hatched = message.hatched;
        break;
      case 'pictures':
        this.looks.takePictures(message.pictures);
        break;
      case 'looks':
        this.looks.show(message.looks);
        break;
      case 'turning':
        // Without a graphics card that would make a run a fifth longer.
        this.turnAlone(message.turning && !this.screen.isInSoftware);
        break;
      case 'turn':
        this.turning = false;
        this.orbit.turn(message);
        this.isTurned = true;
        break;
      case 'folding':
        this.folding = message;
        this.stage = null;
        break;
      case 'time':
        this.wantedTime = message.time;
        break;
      case 'size':
        this.resize(message);
        break;
      case 'end':
        this.end();
        return;
    }
    this.redraw.request();
  }

  /** Frees what it has of the graphics card: the context may be that of others as well. */
  private end(): void {
    this.turning = this.visible = false;
    for (const part of [this.mesh, this.looks, this.lights, this.stepLights]) part.dispose();
    this.screen.end();
  }

  private show({
    vertices,
    faces,
    keepsView,
    isGlass = false,
  }: Extract<ModelMessage, { type: 'model' }>): void {
    this.looks.show(null);
    this.mesh.show(vertices, faces);
    this.mesh.glass = isGlass;
    this.lights.take(faces);
    this.stepLights.take(faces);
    this.folding = this.stage = null;
    this.time = this.wantedTime = 1;
    if (!keepsView) this.orbit.reset(extentOf(this.mesh.positions, viewHeight));
  }

  private light({ edges, from }: Extract<ModelMessage, { type: 'lights' }>): void {
    this.lights.show(edges);
    if (!from || this.wantedTime < 1) return;
    this.turning = false;
    this.orbit.look(from);
  }

  private faceAt(x: number, y: number): number {
    this.camera.updateMatrixWorld();
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.camera);
    return this.mesh.faceAlong(ray);
  }

  private pick({ x, y, why }: Extract<ModelMessage, { type: 'point' }>): void {
    this.listener.answer({ face: this.faceAt(x, y), why });
  }

  private stroke(stroke: Extract<ModelMessage, { type: 'stroke' }>): void {
    this.turning = false;
    // Faces that lie on the table or fly are no model.
    if (stroke.phase === 'begin' && this.time === 1) this.brush.begin(stroke);
    else if (!this.brush.isDown) this.orbit.turn(stroke);
    else if (stroke.phase === 'move') this.brush.move(stroke);
    else {
      const painted = this.brush.end();
      if (painted) this.listener.answer(painted);
    }
  }

  /** Moves the faces to where they are at the wanted time. */
  private fold(): void {
    if (!this.folding || this.wantedTime === this.time) return;
    this.stage ??= new FoldingStage(this.folding);
    // Whoever unfolds the model sees the table from the front, wherever the model was seen from.
    if (this.time === 1) {
      this.stage.turnTable(this.orbit);
      this.mesh.lineCuts(this.stage.netVertices);
    } else if (this.isTurned) this.stage.lookFrom(this.orbit);
    this.isTurned = false;
    this.time = this.wantedTime;
    if (this.time === 1) this.mesh.lineBorders();
    const { positions, normals } = this.mesh;
    this.orbit.frame(this.stage.write(this.time, positions, normals));
    this.mesh.moved();
  }

  private turnAlone(turning: boolean): void {
    if (turning && !this.turning) requestAnimationFrame(this.turnStep);
    this.turning = turning;
  }

  private readonly turnStep = (now: number): void => {
    if (!this.turning) return;
    requestAnimationFrame(this.turnStep);
    if (now - this.lastTurn < turnInterval) return;
    // After a pause, as when the page was in the background, it goes on where it was.
    const seconds = Math.min(now - this.lastTurn, 100) / 1000;
    this.lastTurn = now;
    this.orbit.turn({ around: turnSpeed * seconds, down: 0, away: 1 });
    this.redraw.request();
  };

  private resize({ width, height, density }: PictureSize): void {
    this.visible = width > 0 && height > 0;
    if (!this.visible) return;
    this.screen.resize({ width, height, density });
    this.orbit.fit(width / height);
    // A resized canvas is empty: waiting for the next frame would flash.
    this.draw();
  }

  private draw(): void {
    if (!this.visible) return;
    this.fold();
    this.looks.update(this.time === 1);
    for (const lights of [this.lights, this.stepLights])
      lights.place(this.mesh.positions, this.time === 1);
    this.screen.draw(this.scene, this.camera);
  }
}
