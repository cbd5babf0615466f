// check_schema.mjs PACKAGES ROOT : compiles ROOT/templates/mien.schema.json with ajv in strict mode, then reads the
// repository's YAML files with it: every file of configs/ must pass, and of tests/bad_yaml exactly those that
// tests/config/schema_accepts.txt lists. PACKAGES is the folder with node_modules. Ends with a line of counts.
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join, resolve } from 'node:path';

const MOST_BYTES = 1 << 22;  // of a file's value as JSON: one of many aliases has hardly an end

const [packages, root] = process.argv.slice(2);
const require = createRequire(join(resolve(packages), 'package.json'));
const Ajv = require('ajv/dist/2020').default;
const YAML = require('yaml');

const readText = (...parts) => readFileSync(join(root, ...parts), 'utf8');
const listFiles = (folder) =>
  readdirSync(join(root, folder)).filter((name) => name.endsWith('.yaml')).sort().map((name) => join(folder, name));

// With `strict: true` whatever the draft does not define, or what could be read in two ways, is an error; with
// `strictTypes` and `strictTuples` too, which are else only written to the log.
const ajv = new Ajv({
  strict: true, strictTypes: true, strictTuples: true, allErrors: true, validateFormats: true,
  allowUnionTypes: false, unicodeRegExp: true,
});
let validate;
try {
  validate = ajv.compile(JSON.parse(readText('templates/mien.schema.json')));
} catch (error) {
  console.error(`templates/mien.schema.json: ${error.message}`);
  process.exit(1);
}

// "" if the schema takes the file, else why not: what is no YAML is refused too.
function findRefusal(file) {
  let value;
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(readFileSync(join(root, file)));
    const documents = YAML.parseAllDocuments(text, { version: '1.2', merge: false });
    if (documents.length !== 1) return 'no single document';
    const told = [...documents[0].errors, ...documents[0].warnings];  // a tag that nobody knows is a warning
    if (told.length) return told[0].message.split('\n')[0];
    value = documents[0].toJS({ maxAliasCount: -1 });
    if (JSON.stringify(value).length > MOST_BYTES) return 'too large';
  } catch (error) {
    return `${error.name}: ${error.message.split('\n')[0]}`;
  }
  if (validate(value)) return '';
  const worst = validate.errors.reduce((a, b) => (b.instancePath.length > a.instancePath.length ? b : a));
  return `${worst.instancePath || '/'} ${worst.message}`;
}

const wrong = [];
const good = [...listFiles('configs'), ...listFiles('configs/expressions')];
for (const file of good) {
  const refusal = findRefusal(file);
  if (refusal) wrong.push(`${file} is refused: ${refusal}`);
}

const listed = new Set(
  readText('tests/config/schema_accepts.txt').split('\n').filter((line) => line && !line.startsWith('#')));
const bad = listFiles('tests/bad_yaml');
for (const file of bad) {
  const refusal = findRefusal(file);
  const isListed = listed.delete(basename(file, '.yaml'));
  if (refusal && isListed) wrong.push(`${file} is listed as accepted, and refused: ${refusal}`);
  if (!refusal && !isListed) wrong.push(`${file} is accepted and not listed`);
}
for (const name of listed) wrong.push(`${name} is listed as accepted, and there is no such file`);

for (const line of wrong) console.log(line);
console.log(
  `ajv ${require('ajv/package.json').version} in strict mode: ${good.length} good and ${bad.length} wrong files, ` +
  `${wrong.length} judged otherwise than they should be`);
process.exit(wrong.length || !good.length || !bad.length ? 1 : 0);
