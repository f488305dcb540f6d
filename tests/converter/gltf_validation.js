// Khronos' validator finds nothing wrong in what is written as glTF, and would find what is.
//
//   node gltf_validation.js FOLDER...    all *.glb of the folders; needs gltf-validator
const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

// Errors and warnings, one sentence each.
async function problems(bytes) {
  const report = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 0 });
  const grave = report.issues.messages.filter((message) => message.severity <= 1);
  return grave.map((message) => `${message.code} at ${message.pointer}: ${message.message}`);
}

// The first coordinate of the binary chunk becomes another, which the stated bounds do not hold.
function withMovedVertex(bytes) {
  const moved = Buffer.from(bytes);
  const binary = 20 + moved.readUInt32LE(12) + 8;
  moved.writeFloatLE(1e6, binary);
  return moved;
}

function filesOf(folder) {
  const names = fs.readdirSync(folder).filter((name) => name.endsWith(".glb"));
  if (names.length === 0) throw new Error(`no .glb in ${folder}`);
  return names.map((name) => path.join(folder, name));
}

async function main(folders) {
  const files = folders.flatMap(filesOf);
  let failed = 0;
  for (const name of files) {
    const bytes = fs.readFileSync(name);
    const found = await problems(bytes);
    console.log(`${found.length === 0 ? "ok    " : "FAILED"} ${name}: ${found.join("; ") || "valid"}`);
    const planted = await problems(withMovedVertex(bytes));
    if (planted.length === 0) console.log(`FAILED ${name}: a vertex out of bounds is not found`);
    failed += found.length === 0 && planted.length > 0 ? 0 : 1;
  }
  if (failed > 0) throw new Error(`${failed} of ${files.length} files are not as they should be`);
}

main(process.argv.slice(2)).catch((error) => {
  console.error(error.message);
  process.exit(1);
});
