// Khronos' validator must find nothing at all in our glTF files. Usage: node check_gltf.mjs FOLDER
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

let validator;
try {
  validator = (await import('gltf-validator')).default;
} catch {
  console.log('skipped: run `npm ci` in tests/interop first');
  process.exit(77);
}

const folder = process.argv[2];
const files = readdirSync(folder).filter((name) => name.endsWith('.glb'));
if (files.length < 4) {
  console.error(`only ${files.length} .glb files in ${folder}`);
  process.exit(1);
}
let failed = false;
for (const name of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, name))), { uri: name });
  const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
  console.log(`${name}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ` +
              `${report.info.animationCount} animations`);
  for (const message of messages) {
    console.error(`  ${message.code} ${message.pointer}: ${message.message}`);
  }
  failed ||= numErrors + numWarnings + numInfos + numHints > 0;
  failed ||= report.info.animationCount !== (name === 'still.glb' ? 0 : 1);
}
process.exit(failed ? 1 : 0);
