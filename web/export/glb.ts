import { bodiesOf } from '../model/body.js';
import { ballOf } from '../model/bounds.js';
import { choreograph, foldEnd, type Track } from '../model/choreography.js';
import { foldTree, type FoldTree } from '../model/fold-tree.js';
import { flatVertex } from '../model/folded-piece.js';
import type { JobResult, Piece } from '../model/job.js';
import { partRgb } from '../model/part-colours.js';
import { turnAround } from '../model/pose.js';
import { secondOf, tempoFor } from '../model/tempo.js';
import { minus, times as scaled, type Vector } from '../model/vector.js';
import { glbFile, GlbNumbers } from './glb-file.js';
import { panelsOf, type Panel } from './panels.js';

/** The format counts in metres. */
const metres = 0.001;

/** The format's y is up: sheets lie on the ground, their printed sides up. */
const ground = turnAround([1, 0, 0], -Math.PI / 2);

interface Node {
  name?: string;
  translation?: Vector;
  rotation?: readonly number[];
  mesh?: number;
  children?: number[];
}

interface Channel {
  sampler: number;
  target: { node: number; path: 'translation' | 'rotation' };
}

/** A channel of the screen's colours, 0 to 255, as a share of light (sRGB's own curve). */
function light(value: number): number {
  const share = value / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

function paper(part: number): object {
  const colour = partRgb(part).map(light);
  return {
    name: `Part ${part + 1}`,
    pbrMetallicRoughness: { baseColorFactor: [...colour, 1], metallicFactor: 0 },
    // Before it is closed one sees the inside, too.
    doubleSided: true,
  };
}

/** Collects what the file consists of, piece by piece. */
class Scene {
  private readonly numbers = new GlbNumbers();
  private readonly nodes: Node[] = [];
  private readonly meshes: object[] = [];
  private readonly samplers: object[] = [];
  private readonly channels: Channel[] = [];
  private readonly roots: number[] = [];

  /** @param seconds when a time of the choreography comes */
  constructor(private readonly seconds: (time: number) => number) {}

  addPiece(piece: Piece, tree: FoldTree, track: Track): void {
    const panels = panelsOf(piece, tree);
    const nodes = panels.map((panel) => this.addPanel(piece, panels, panel));
    panels.forEach(({ parent }, i) => {
      if (parent >= 0) (this.nodes[nodes[parent]!]!.children ??= []).push(nodes[i]!);
    });
    const root = nodes[0]!;
    const { turn, move } = track.poses[0]!;
    const name = `Piece ${piece.name}`;
    Object.assign(this.nodes[root]!, { name, translation: scaled(move, metres), rotation: turn });
    this.roots.push(root);
    this.addFolds(piece, panels, nodes);
    this.addFlight(root, track);
  }

  write(parts: number): Uint8Array {
    const { nodes, meshes, samplers, channels } = this;
    const file = {
      asset: { version: '2.0', generator: 'Foldwright' },
      scene: 0,
      scenes: [{ nodes: this.roots }],
      nodes,
      meshes,
      materials: Array.from({ length: parts }, (_, part) => paper(part)),
      animations: [{ name: 'Fold and assemble', samplers, channels }],
      ...this.numbers.describe(),
    };
    return glbFile(file, this.numbers.bytes());
  }

  /** A node at a point of the panel's hinge; its axes are those of the sheet until it turns. */
  private addPanel(piece: Piece, panels: Panel[], { faces, parent, point }: Panel): number {
    const corners = faces.flatMap((face) =>
      [...piece.faces.subarray(3 * face, 3 * face + 3)].flatMap((vertex) =>
        scaled(minus(flatVertex(piece, vertex), point), metres),
      ),
    );
    // Without normals the format shades faces flat, as paper is.
    const primitive = {
      attributes: { POSITION: this.numbers.addCorners(corners) },
      material: piece.part,
    };
    const mesh = this.meshes.push({ primitives: [primitive] }) - 1;
    const above = panels[parent];
    const translation = above && { translation: scaled(minus(point, above.point), metres) };
    return this.nodes.push({ ...translation, mesh }) - 1;
  }

  /** Turns every panel around its hinge, by the keys of the motion or evenly without one. */
  private addFolds({ foldAngles, motion }: Piece, panels: Panel[], nodes: number[]): void {
    const times = motion?.times ?? Float64Array.of(0, 1);
    const seconds = Array.from(times, (time) => this.seconds(foldEnd * time));
    const input = panels.length > 1 ? this.numbers.addSeconds(seconds) : -1;
    panels.forEach(({ edge, axis, parent }, i) => {
      if (parent < 0) return;
      const angles = Array.from(times, (time, key) =>
        motion ? motion.angles[key * foldAngles.length + edge]! : time * foldAngles[edge]!,
      );
      const turns = angles.flatMap((angle) => turnAround(axis, (angle * Math.PI) / 180));
      this.animate(nodes[i]!, 'rotation', input, this.numbers.addKeys('VEC4', turns));
    });
  }

  private addFlight(node: number, { times, poses }: Track): void {
    const input = this.numbers.addSeconds(times.map(this.seconds));
    const moves = poses.flatMap(({ move }) => scaled(move, metres));
    const turns = poses.flatMap(({ turn }) => turn);
    this.animate(node, 'translation', input, this.numbers.addKeys('VEC3', moves));
    this.animate(node, 'rotation', input, this.numbers.addKeys('VEC4', turns));
  }

  private animate(
    node: number,
    path: 'translation' | 'rotation',
    input: number,
    output: number,
  ): void {
    const sampler = this.samplers.push({ input, interpolation: 'LINEAR', output }) - 1;
    this.channels.push({ sampler, target: { node, path } });
  }
}

/**
 * The folding of all pieces and their assembly as a binary glTF 2.0 file: metres, y up, one
 * animation. At its first second the pieces lie flat on the ground, side by side; at its last one
 * they are the model, where the model is, in the colours of the parts. Every panel is a mesh at a
 * node of its own that turns around the hinge to the panel before it. Pieces without a motion fold
 * evenly, and faces may pass through each other. The same result gives the same bytes.
 */
export function writeGlb(result: JobResult): Uint8Array {
  const { pieces, parts } = result;
  const tempo = tempoFor(pieces.length);
  const scene = new Scene((time) => secondOf(tempo, time));
  const trees = pieces.map(foldTree);
  const tracks = choreograph(bodiesOf(result, trees), ballOf(result.model.vertices), ground);
  pieces.forEach((piece, i) => scene.addPiece(piece, trees[i]!, tracks[i]!));
  return scene.write(parts);
}
