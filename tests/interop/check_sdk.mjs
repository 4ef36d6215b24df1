// Autodesk's SDK, which is inside fbx2gltf, must find in our FBX files what FILE.expected.json beside each says.
// Usage: node check_sdk.mjs FOLDER
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

import { LARGEST_VERTEX_ERROR_M, checkAll, farthest, fromYUp, largest } from './expected.mjs';

let THREE, converter;
try {
  THREE = await import('three');
  converter = join(dirname(createRequire(import.meta.url).resolve('fbx2gltf')), 'bin', 'Linux', 'FBX2glTF');
  chmodSync(converter, 0o755);
} catch {
  console.log('skipped: run `npm ci` in tests/interop first');
  process.exit(77);
}

// --- a small reader of binary glTF: nodes, linear animation, skins ---
function readGlb(path) {
  const bytes = readFileSync(path);
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
  const binary = bytes.subarray(20 + bytes.readUInt32LE(12) + 8);
  const accessor = (index) => {
    const { bufferView, byteOffset = 0, count, type, componentType } = json.accessors[index];
    const view = json.bufferViews[bufferView];
    const width = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 }[type];
    const [size, read] = { 5121: [1, 'readUInt8'], 5123: [2, 'readUInt16LE'], 5125: [4, 'readUInt32LE'],
                           5126: [4, 'readFloatLE'] }[componentType];
    const stride = view.byteStride ?? size * width;
    const start = (view.byteOffset ?? 0) + byteOffset;
    return Array.from({ length: count }, (_, i) =>
      Array.from({ length: width }, (_, k) => binary[read](start + i * stride + k * size)));
  };
  return { json, accessor };
}

// World matrices of all nodes at a time at which there are keys.
function gltfWorlds({ json, accessor }, cache, time) {
  const locals = json.nodes.map((node) => ({
    t: node.translation ?? [0, 0, 0], r: node.rotation ?? [0, 0, 0, 1], s: node.scale ?? [1, 1, 1] }));
  for (const channel of json.animations?.[0].channels ?? []) {
    const { input, output } = json.animations[0].samplers[channel.sampler];
    cache[input] ??= accessor(input).map(([t]) => t);
    cache[output] ??= accessor(output);
    const key = cache[input].reduce((best, t, i, all) => Math.abs(t - time) < Math.abs(all[best] - time) ? i : best, 0);
    const property = { translation: 't', rotation: 'r', scale: 's' }[channel.target.path];
    if (property) {
      locals[channel.target.node][property] = cache[output][key];
    }
  }
  const worlds = [];
  const visit = (index, parent) => {
    const { t, r, s } = locals[index];
    const local = new THREE.Matrix4().compose(new THREE.Vector3(...t), new THREE.Quaternion(...r),
                                              new THREE.Vector3(...s));
    worlds[index] = parent.clone().multiply(local);
    (json.nodes[index].children ?? []).forEach((child) => visit(child, worlds[index]));
  };
  json.scenes[json.scene ?? 0].nodes.forEach((node) => visit(node, new THREE.Matrix4()));
  return worlds;
}

const position = (matrix) => fromYUp(new THREE.Vector3().setFromMatrixPosition(matrix).toArray());

// Vertices of all skinned meshes.
function gltfVertices({ json, accessor }, worlds) {
  return json.nodes.filter((item) => item.skin !== undefined).flatMap((node) => {
    const skin = json.skins[node.skin];
    const inverse = accessor(skin.inverseBindMatrices).map((m) => new THREE.Matrix4().fromArray(m));
    const bones = skin.joints.map((joint, i) => worlds[joint].clone().multiply(inverse[i]));
    return json.meshes[node.mesh].primitives.flatMap(({ attributes }) => {
      const [positions, joints, weights] =
        [attributes.POSITION, attributes.JOINTS_0, attributes.WEIGHTS_0].map(accessor);
      return positions.map((p, v) => {
        const sum = new THREE.Vector3();
        joints[v].forEach((joint, k) =>
          sum.addScaledVector(new THREE.Vector3(...p).applyMatrix4(bones[joint]), weights[v][k]));
        return fromYUp(sum.toArray());
      });
    });
  });
}

// The SDK bakes at 24, 30 or 60 frames a second; only keys that it then meets can be held to the bar for keys.
const bakeRate = (fps) => [60, 30, 24].find((rate) => Math.abs(fps / rate - Math.round(fps / rate)) < 1e-9);

const work = mkdtempSync(join(tmpdir(), 'limbwave-fbx-'));

await checkAll(['.fbx'], 40, (path, expected, demand) => {
  const rate = bakeRate(expected.fps) ?? 60;
  const out = join(work, 'out.glb');
  rmSync(out, { force: true });
  const run = spawnSync(converter, ['-b', '-i', path, '-o', out, '--anim-framerate', `bake${rate}`, '--fbx-temp-dir',
                                    work], { encoding: 'utf8' });
  demand(run.status === 0, `${run.error ?? run.stdout}`);
  const glb = readGlb(out);
  // It says nothing when it could not read the animation.
  const still = path.includes('still') || (expected.foreign && expected.duration_s === 0);
  demand((glb.json.animations?.length ?? 0) === (still ? 0 : 1), `${glb.json.animations?.length} animations`);
  demand(still || expected.foreign || glb.json.animations?.[0].name === expected.name,
         `the animation is "${glb.json.animations?.[0].name}"`);
  const nodes = expected.joints.map((name) => glb.json.nodes.findIndex((node) => node.name === name));
  demand(nodes.every((index) => index >= 0), 'bones are missing');
  const cache = {};
  let atKeys = 0;
  let atVertices = 0;
  let compared = 0;
  for (const sample of expected.samples) {
    const frame = sample.time_s * rate;
    if (Math.abs(frame - Math.round(frame)) > 1e-6 || bakeRate(expected.fps) === undefined) {
      continue;
    }
    ++compared;
    const worlds = gltfWorlds(glb, cache, sample.time_s);
    const error = largest(nodes.map((index) => position(worlds[index])), sample.heads);
    atKeys = Math.max(atKeys, sample.bar_m < 1e-3 ? error : 0);
    demand(error <= sample.bar_m, `at ${sample.time_s} s a joint is ${error} m off`);
    if (sample.vertices) {
      const off = farthest(sample.vertices.flat(), gltfVertices(glb, worlds));
      atVertices = Math.max(atVertices, off);
      demand(off <= LARGEST_VERTEX_ERROR_M, `at ${sample.time_s} s a vertex is ${off} m off`);
    }
  }
  return `keys ${atKeys.toExponential(1)} m (${compared} poses), vertices ${atVertices.toExponential(1)} m`;
}).finally(() => rmSync(work, { recursive: true }));
