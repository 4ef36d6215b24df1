// Autodesk's SDK (inside fbx2gltf) and three.js must find in our FBX files what FILE.json beside each says.
// Usage: node check_fbx.mjs FOLDER
import { spawnSync } from 'node:child_process';
import { chmodSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';

let THREE, FBXLoader, converter;
try {
  THREE = await import('three');
  ({ FBXLoader } = await import('three/addons/loaders/FBXLoader.js'));
  const require = createRequire(import.meta.url);
  converter = join(dirname(require.resolve('fbx2gltf')), 'bin', 'Linux', 'FBX2glTF');
} catch {
  console.log('skipped: run `npm ci` in tests/interop first');
  process.exit(77);
}

const LARGEST_VERTEX_ERROR_M = 1e-3;
// Blender's world, in which positions are given, from that of Y-up files.
const fromYUp = ([x, y, z]) => [x, -z, y];
const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const largest = (found, expected) => Math.max(...expected.map((p, i) => distance(found[i], p)));

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

function gltfVertices({ json, accessor }, worlds) {
  const node = json.nodes.find((item) => item.skin !== undefined);
  const skin = json.skins[node.skin];
  const inverse = accessor(skin.inverseBindMatrices).map((m) => new THREE.Matrix4().fromArray(m));
  const bones = skin.joints.map((joint, i) => worlds[joint].clone().multiply(inverse[i]));
  const { POSITION, JOINTS_0, WEIGHTS_0 } = json.meshes[node.mesh].primitives[0].attributes;
  const [positions, joints, weights] = [POSITION, JOINTS_0, WEIGHTS_0].map(accessor);
  return positions.map((p, v) => {
    const sum = new THREE.Vector3();
    joints[v].forEach((joint, k) =>
      sum.addScaledVector(new THREE.Vector3(...p).applyMatrix4(bones[joint]), weights[v][k]));
    return fromYUp(sum.toArray());
  });
}

// The SDK bakes at 24, 30 or 60 frames a second; only keys that it then meets can be compared.
function bakeRate(fps) {
  return [60, 30, 24].find((rate) => Math.abs(fps / rate - Math.round(fps / rate)) < 1e-9);
}

function checkSdk(path, expected, folder, demand) {
  const rate = bakeRate(expected.fps) ?? 60;
  const out = join(folder, 'out.glb');
  rmSync(out, { force: true });
  chmodSync(converter, 0o755);
  const run = spawnSync(converter, ['-b', '-i', path, '-o', out, '--anim-framerate', `bake${rate}`, '--fbx-temp-dir',
                                    folder], { encoding: 'utf8' });
  demand(run.status === 0, `SDK: ${run.error ?? run.stdout}`);
  const glb = readGlb(out);
  // It says nothing when it could not read the animation.
  demand(glb.json.animations?.length === 1, 'SDK: no animation');
  demand(glb.json.animations?.[0].name === expected.name, `SDK: the animation is "${glb.json.animations?.[0].name}"`);
  const nodes = expected.joints.map((name) => glb.json.nodes.findIndex((node) => node.name === name));
  demand(nodes.every((index) => index >= 0), 'SDK: bones are missing');
  const cache = {};
  let atKeys = 0;
  let atVertices = 0;
  let compared = 0;
  for (const sample of expected.samples) {
    const onGrid = Math.abs(sample.time_s * rate - Math.round(sample.time_s * rate)) < 1e-6;
    if (!onGrid || sample.bar_m > 1e-4 || bakeRate(expected.fps) === undefined) {
      continue;
    }
    ++compared;
    const worlds = gltfWorlds(glb, cache, sample.time_s);
    const error = largest(nodes.map((index) => position(worlds[index])), sample.heads);
    atKeys = Math.max(atKeys, error);
    demand(error <= sample.bar_m, `SDK: at ${sample.time_s} s a joint is ${error} m off`);
    if (sample.vertices) {
      // The SDK's user splits vertices by their normals and drops what no triangle has: each must have its like.
      const found = gltfVertices(glb, worlds);
      const off = Math.max(...sample.vertices.map((p) => Math.min(...found.map((q) => distance(p, q)))));
      atVertices = Math.max(atVertices, off);
      demand(off <= LARGEST_VERTEX_ERROR_M, `SDK: at ${sample.time_s} s a vertex is ${off} m off`);
    }
  }
  const times = Object.values(cache).filter((values) => typeof values[0] === 'number');
  return `SDK keys ${atKeys.toExponential(1)} m (${compared} poses, ${times[0]?.length ?? 0} keys), vertices ` +
         `${atVertices.toExponential(1)} m`;
}

function checkThree(path, expected, demand) {
  const bytes = readFileSync(path);
  const scene = new FBXLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  // The loader leaves lengths as they are and says how many centimetres they are.
  const metres = (scene.userData.unitScaleFactor ?? 1) / 100;
  demand(scene.animations.length === 1, `three: ${scene.animations.length} animations`);
  const clip = scene.animations[0];
  demand(Math.abs(clip.duration - expected.duration_s) < 1e-6 * Math.max(1, expected.duration_s),
         `three: it lasts ${clip.duration} s, not ${expected.duration_s}`);
  const bones = expected.joints.map((name) => {
    let bone;
    scene.traverse((item) => {
      bone ??= item.isBone && item.name === THREE.PropertyBinding.sanitizeNodeName(name) ? item : undefined;
    });
    return bone;
  });
  demand(bones.every(Boolean), 'three: bones are missing');
  const mixer = new THREE.AnimationMixer(scene);
  const action = mixer.clipAction(clip);
  action.setLoop(THREE.LoopOnce);
  action.clampWhenFinished = true;
  action.play();
  let atKeys = 0;
  let between = 0;
  let atVertices = 0;
  for (const sample of expected.samples) {
    mixer.setTime(Math.fround(sample.time_s));  // where its 32-bit key times lie
    scene.updateMatrixWorld(true);
    const scaled = (v) => fromYUp(v.multiplyScalar(metres).toArray());
    const heads = bones.map((bone) => scaled(new THREE.Vector3().setFromMatrixPosition(bone.matrixWorld)));
    const error = largest(heads, sample.heads);
    if (sample.bar_m > 1e-4) {
      between = Math.max(between, error);
    } else {
      atKeys = Math.max(atKeys, error);
    }
    demand(error <= sample.bar_m, `three: at ${sample.time_s} s a joint is ${error} m off`);
    if (sample.vertices) {
      let mesh;
      scene.traverse((item) => { mesh = item.isSkinnedMesh ? item : mesh; });
      mesh.skeleton.update();
      const found = Array.from({ length: mesh.geometry.attributes.position.count }, (_, i) =>
        scaled(mesh.applyBoneTransform(i, new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position, i))
                   .applyMatrix4(mesh.matrixWorld)));
      const off = Math.max(...sample.vertices.map((p) => Math.min(...found.map((q) => distance(p, q)))));
      atVertices = Math.max(atVertices, off);
      demand(off <= LARGEST_VERTEX_ERROR_M, `three: at ${sample.time_s} s a vertex is ${off} m off`);
    }
  }
  return `three keys ${atKeys.toExponential(1)} m, between ${between.toExponential(1)} m, vertices ` +
         `${atVertices.toExponential(1)} m`;
}

const folder = process.argv[2];
const files = readdirSync(folder).filter((name) => name.endsWith('.fbx'));
if (files.length < 5) {
  console.error(`only ${files.length} .fbx files in ${folder}`);
  process.exit(1);
}
const work = mkdtempSync(join(tmpdir(), 'limbwave-fbx-'));
let failed = false;
for (const name of files) {
  const expected = JSON.parse(readFileSync(join(folder, name.replace('.fbx', '.json')), 'utf8'));
  const problems = [];
  const demand = (truth, text) => { if (!truth) problems.push(text); };
  for (const check of [() => checkSdk(join(folder, name), expected, work, demand),
                       () => checkThree(join(folder, name), expected, demand)]) {
    try {
      console.log(`${name}: ${check()}`);
    } catch (error) {
      problems.push(error.stack);
    }
  }
  problems.slice(0, 6).forEach((problem) => console.error(`  ${name}: ${problem}`));
  failed ||= problems.length > 0;
}
rmSync(work, { recursive: true });
process.exit(failed ? 1 : 0);
