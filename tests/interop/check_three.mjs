// three.js must find in our FBX, glTF and BVH files what FILE.expected.json beside each says.
// Usage: node check_three.mjs FOLDER
import { readFileSync } from 'node:fs';

import { LARGEST_VERTEX_ERROR_M, checkAll, farthest, fromYUp, largest } from './expected.mjs';

let THREE, FBXLoader, GLTFLoader, BVHLoader;
globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class extends Event {};
try {
  THREE = await import('three');
  ({ FBXLoader } = await import('three/addons/loaders/FBXLoader.js'));
  ({ GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js'));
  ({ BVHLoader } = await import('three/addons/loaders/BVHLoader.js'));
} catch {
  console.log('skipped: run `npm ci` in tests/interop first');
  process.exit(77);
}
console.warn = () => {};  // it tells of Z-up files and of extensions that it does not know

// A scene, its animations and the length of its unit.
async function load(path, expected) {
  const bytes = readFileSync(path);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  if (path.endsWith('.fbx')) {
    const scene = new FBXLoader().parse(buffer, '');
    // The loader leaves lengths as they are and says how many centimetres they are.
    return { scene, clips: scene.animations, metres: (scene.userData.unitScaleFactor ?? 1) / 100 };
  }
  if (path.endsWith('.bvh')) {
    const { skeleton, clip } = new BVHLoader().parse(bytes.toString('utf8'));
    const scene = new THREE.Group();
    scene.add(skeleton.bones[0]);
    return { scene, clips: [clip], metres: expected.metres_per_unit };
  }
  const { scene, animations } = await new GLTFLoader().parseAsync(buffer, '');
  return { scene, clips: animations, metres: 1 };
}

await checkAll(['.fbx', '.glb', '.gltf', '.vrm', '.bvh'], 80, async (path, expected, demand) => {
  if (expected === undefined) {
    return 'not looked at';
  }
  const { scene, clips, metres } = await load(path, expected);
  const still = path.includes('still');
  demand(expected.foreign || clips.length === (still ? 0 : 1), `${clips.length} animations`);
  const duration = clips[0]?.duration ?? 0;
  demand(expected.foreign || Math.abs(duration - expected.duration_s) < 1e-6 * Math.max(1, expected.duration_s),
         `it lasts ${duration} s, not ${expected.duration_s}`);
  // It adds OFFSETs to position channels, which replace them elsewhere, and scales foreign FBX trees otherwise.
  const adds = path.endsWith('.bvh') && readFileSync(path, 'utf8').split('JOINT').some((joint) =>
    /CHANNELS\s+6/.test(joint) && /OFFSET(\s+-?[\d.e-]+){3}/.exec(joint)?.[0].split(/\s+/).slice(1).some(Number));
  if (adds || (expected.foreign && path.endsWith('.fbx'))) {
    return 'read otherwise';
  }
  const nodes = expected.joints.map((name) => {
    let node;
    const clean = path.endsWith('.bvh') ? name : THREE.PropertyBinding.sanitizeNodeName(name);
    scene.traverse((item) => { node ??= item.name === clean ? item : undefined; });
    return node;
  });
  if (expected.foreign && path.endsWith('.gltf') && !nodes.every(Boolean)) {
    return 'its nodes have no names';
  }
  demand(nodes.every(Boolean), `bones are missing: ${expected.joints.filter((_, i) => !nodes[i])}`);
  demand(expected.meshes.length === 0 && !path.endsWith('.bvh') && !path.endsWith('.fbx') ||
         nodes.every((node) => node.isBone), 'joints are no bones');
  const mixer = new THREE.AnimationMixer(scene);
  if (clips[0]) {
    const action = mixer.clipAction(clips[0]);
    action.setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
  }
  const worst = { keys: 0, between: 0, vertices: 0 };
  for (const sample of expected.samples) {
    // Its key times are 32-bit; those of other programs' BVH are rounded.
    const rounded = expected.foreign && path.endsWith('.bvh');
    const key = rounded ? clips[0].tracks[0].times[Math.round(sample.time_s * expected.fps)] : sample.time_s;
    mixer.setTime(sample.at_key ? Math.fround(key) : key);
    scene.updateMatrixWorld(true);
    const scaled = (v) => fromYUp(v.multiplyScalar(metres).toArray());
    const heads = nodes.map((node) => scaled(new THREE.Vector3().setFromMatrixPosition(node.matrixWorld)));
    const error = largest(heads, sample.heads);
    const kind = sample.bar_m < 1e-3 ? 'keys' : 'between';
    worst[kind] = Math.max(worst[kind], error);
    demand(error <= sample.bar_m, `at ${sample.time_s} s a joint is ${error} m off`);
    if (sample.vertices) {
      const found = [];
      scene.traverse((item) => {
        if (!item.isSkinnedMesh) return;
        item.skeleton.update();
        const { position } = item.geometry.attributes;
        for (let i = 0; i < position.count; ++i) {
          const bound = new THREE.Vector3().fromBufferAttribute(position, i);
          found.push(scaled(item.applyBoneTransform(i, bound).applyMatrix4(item.matrixWorld)));
        }
      });
      const off = farthest(sample.vertices.flat(), found);
      worst.vertices = Math.max(worst.vertices, off);
      demand(off <= LARGEST_VERTEX_ERROR_M, `at ${sample.time_s} s a vertex is ${off} m off`);
    }
  }
  return Object.entries(worst).map(([kind, error]) => `${kind} ${error.toExponential(1)} m`).join(', ');
});
