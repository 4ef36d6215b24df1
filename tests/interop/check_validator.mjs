// Khronos' validator must find nothing at all in our glTF files. Usage: node check_validator.mjs FOLDER
import { readFileSync } from 'node:fs';

import { checkAll } from './expected.mjs';

let validator;
try {
  validator = (await import('gltf-validator')).default;
} catch {
  console.log('skipped: run `npm ci` in tests/interop first');
  process.exit(77);
}

await checkAll(['.glb', '.gltf', '.vrm'], 40, async (path, expected, demand) => {
  if (path.includes('foreign_')) {
    return 'not ours';
  }
  // VRM's own extension is the only thing that the validator does not know and therefore mentions.
  const ignoredIssues = path.endsWith('.vrm') ? ['UNSUPPORTED_EXTENSION'] : [];
  const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(path)), { uri: path, ignoredIssues });
  for (const { code, pointer, message } of issues.messages) {
    demand(false, `${code} ${pointer}: ${message}`);
  }
  const { numErrors, numWarnings, numInfos, numHints } = issues;
  demand(numErrors + numWarnings + numInfos + numHints === 0, 'it has findings');
  const animations = path.includes('still') ? 0 : 1;
  demand(info.animationCount === animations, `${info.animationCount} animations`);
  return `${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints`;
});
