// Ajv in strict mode on the schemas, on documents that are sound and on such that hold one fault.
//
// usage: node validate.js SCHEMAS DOCUMENTS FAULTS     folders; documents are SCHEMA/NAME.json
'use strict';
const fs = require('fs');
const path = require('path');
const Ajv = require('ajv');

const [schemas, documents, faults] = process.argv.slice(2);
const read = (file) => JSON.parse(fs.readFileSync(file, 'utf8'));
const list = (folder) => fs.readdirSync(folder).sort().map((name) => path.join(folder, name));

// Draft-07 is Ajv's own default. Beyond it, strict mode refuses what a schema probably does not mean; a type that may be
// null, and one that an "if" has looked at before, are meant.
const ajv = new Ajv({ strict: true, allowUnionTypes: true, strictRequired: false });

let wrong = 0;
const counts = { sound: 0, faulty: 0 };
for (const file of list(schemas)) {
  const validate = ajv.compile(read(file));
  const kind = path.basename(file, '.schema.json');
  for (const [folder, what] of [[documents, 'sound'], [faults, 'faulty']]) {
    const found = list(path.join(folder, kind));
    if (found.length === 0) throw new Error(`${folder} has no document for ${kind}`);
    for (const document of found) {
      counts[what] += 1;
      if (validate(read(document)) === (what === 'sound')) continue;
      wrong += 1;
      console.error(`${document}: ${what === 'sound' ? ajv.errorsText(validate.errors) : 'is not refused'}`);
    }
  }
}
if (wrong > 0) process.exit(1);
console.log(`${counts.sound} documents accepted, ${counts.faulty} faults refused`);
