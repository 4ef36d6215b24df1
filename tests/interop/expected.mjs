// What the checks of JavaScript's readers share: the files of a folder, what is expected of them, and how it is said
// that they differ.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

export const LARGEST_VERTEX_ERROR_M = 1e-3;

// Blender's world, in which positions are given, from that of Y-up files.
export const fromYUp = ([x, y, z]) => [x, -z, y];
export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
export const largest = (found, expected) => Math.max(...expected.map((p, i) => distance(found[i], p)));

// How far the vertices are from the nearest ones found: readers split vertices and drop what no triangle has. Vertices
// are looked up by cells of a millimetre's order.
export function farthest(expected, found) {
  const cell = 4 * LARGEST_VERTEX_ERROR_M;
  const cells = new Map();
  const key = (i, j, k) => `${i},${j},${k}`;
  const index = (p) => p.map((x) => Math.floor(x / cell));
  for (const p of found) {
    const at = key(...index(p));
    (cells.get(at) ?? cells.set(at, []).get(at)).push(p);
  }
  let worst = 0;
  for (const p of expected) {
    const [i, j, k] = index(p);
    let best = Infinity;
    for (let a = -1; a <= 1; ++a) for (let b = -1; b <= 1; ++b) for (let c = -1; c <= 1; ++c) {
      for (const q of cells.get(key(i + a, j + b, k + c)) ?? []) {
        best = Math.min(best, distance(p, q));
      }
    }
    worst = Math.max(worst, best);
  }
  return worst;
}

// Calls check(path, expected, demand), which returns what it measured, for every file with one of the endings.
export async function checkAll(endings, least, check) {
  const folder = process.argv[2];
  const names = readdirSync(folder).filter((name) => endings.some((ending) => name.endsWith(ending)));
  if (names.length < least) {
    console.error(`only ${names.length} files in ${folder}`);
    process.exit(1);
  }
  const bad = [];
  for (const name of names.sort()) {
    const beside = join(folder, `${name}.expected.json`);
    const expected = existsSync(beside) ? JSON.parse(readFileSync(beside, 'utf8')) : undefined;
    const problems = [];
    const demand = (truth, text) => { if (!truth) problems.push(text); };
    try {
      console.log(`${name}: ${await check(join(folder, name), expected, demand)}`);
    } catch (error) {
      problems.push(error.stack);
    }
    problems.slice(0, 5).forEach((problem) => console.error(`  ${name}: ${problem}`));
    if (problems.length > 0) bad.push(name);
  }
  console.log(`${names.length} files`);
  if (bad.length > 0) {
    console.error(`Error: other things than expected are in ${bad.length} of ${names.length} files: ${bad.join(' ')}`);
    process.exit(1);
  }
}
