// The language's words: what may stand at a place of the file, and what it means. From the JSON Schema.

let schema = {};
let ownExpressions = [];

/** The schema that all others here ask. */
export function setSchema(value) {
  schema = value;
}

/** Names of the file's own expressions. */
export function setOwnExpressions(names) {
  ownExpressions = names;
}

const kMostDepth = 12;  // of references to references

// All plain schemas that a schema stands for, each with the words that stand nearest to it.
function expand(node, depth = 0) {
  if (!node || typeof node !== "object" || depth > kMostDepth) return [];
  const own = {};
  for (const word of ["description", "default"]) if (node[word] !== undefined) own[word] = node[word];
  if (node.$ref) {
    const name = node.$ref.replace("#/$defs/", "");
    return expand(schema.$defs?.[name], depth + 1).map((found) => ({...found, ...own, from: [...(found.from ?? []), name]}));
  }
  const choices = node.anyOf ?? node.oneOf ?? node.allOf;
  if (!choices || node.properties) return [node];  // beside properties choices only say which go together
  // A choice among words keeps the words' own meanings.
  return choices.flatMap((choice) => expand(choice, depth + 1))
    .map((found) => ({...found, ...(found.const === undefined ? own : {}), about: own.description ?? found.about, without: own.default ?? found.without}));
}

function step(nodes, key) {
  return nodes.flatMap((node) => {
    if (typeof key === "number") return expand(node.prefixItems?.[key] ?? node.items);
    return expand(node.properties?.[key] ?? node.additionalProperties);
  });
}

/** The schemas of the value at `path`. */
export function findSchemas(path) {
  return path.reduce(step, expand(schema));
}

/** The raw schema at a path of keys alone, for building controls. */
export function findSchema(path) {
  return findSchemas(path)[0] ?? {};
}

/** The keys of the mapping at `path`: [{word, meaning, isMapping}]. */
export function listKeys(path) {
  const keys = new Map();
  for (const node of findSchemas(path))
    for (const [word, property] of Object.entries(node.properties ?? {})) {
      if (property === false || keys.has(word)) continue;
      const found = expand(property);
      keys.set(word, {word, meaning: property.description ?? found[0]?.about ?? found[0]?.description ?? "",
                      isMapping: found.length > 0 && found.every((one) => one.type === "object"),
                      isList: found.length > 0 && found.every((one) => one.type === "array")});
    }
  if (namesExpressions(path)) for (const word of ownExpressions) keys.set(word, {word, meaning: "of this file"});
  return [...keys.values()];
}

// Whether the value at `path` is a name of an expression, or a mapping of such names.
function namesExpressions(path) {
  return findSchemas(path).some((node) => node.from?.includes("expressions"));
}

/** The words that may stand as the value at `path`: [{word, meaning}]. */
export function listValues(path) {
  const values = new Map();
  if (namesExpressions(path)) for (const word of ownExpressions) values.set(word, {word, meaning: "of this file"});
  for (const node of findSchemas(path)) {
    if (node.const !== undefined && !values.has(String(node.const)))
      values.set(String(node.const), {word: String(node.const), meaning: node.description ?? ""});
    for (const word of node.enum ?? []) if (!values.has(String(word))) values.set(String(word), {word: String(word), meaning: ""});
    if (node.type === "boolean") for (const word of ["true", "false"]) values.set(word, {word, meaning: ""});
  }
  return [...values.values()];
}

function describeKind(node) {
  const low = node.minimum ?? node.exclusiveMinimum, high = node.maximum ?? node.exclusiveMaximum;
  if (node.type === "number" || node.type === "integer") {
    const kind = node.type === "integer" ? "a whole number" : "a number";
    return low !== undefined && high !== undefined ? `${kind} from ${low} to ${high}` : kind;
  }
  if (node.from?.includes("formula") || node.from?.includes("constant")) return "a formula in quotes";
  if (node.from?.includes("colour")) return "a colour in quotes";
  if (/\(s\|ms\|f\)/.test(node.pattern ?? "")) return "a time (1.5s, 36f, 500ms)";
  if (/deg/.test(node.pattern ?? "")) return "an angle (20deg)";
  if (/mm/.test(node.pattern ?? "")) return "a length (80mm)";
  if (node.type === "array") return "a list";
  if (node.type === "object") return "a mapping";
  if (node.type === "boolean") return "true or false";
  return null;
}

const kMostWords = 12;  // more are for completion to show

/** What the value at `path` is: {meaning, kinds: text, without: text}. */
export function describeValue(path) {
  const nodes = findSchemas(path);
  const words = nodes.filter((node) => node.const !== undefined).map((node) => String(node.const));
  const kinds = [...new Set(nodes.map(describeKind).filter(Boolean))];
  if (words.length) kinds.unshift(words.length > kMostWords ? `one of ${words.length} names` : words.join(", "));
  const without = nodes.map((node) => node.without ?? node.default).find((value) => value !== undefined);
  const meaning = nodes.map((node) => node.about).find(Boolean) ?? nodes.find((node) => node.const === undefined)?.description ?? "";
  return {meaning, kinds: kinds.join("; or "), without: without === undefined ? "" : String(without)};
}

/** What `word` means as a key in the mapping at `path`, or as the value at `path`: {title, meaning, kinds, without}; or null. */
export function explain(kind, path, word) {
  if (kind === "key") {
    const whole = [...path, word];
    if (findSchemas(whole).length === 0) return null;
    const key = listKeys(path).find((one) => one.word === word);
    const value = describeValue(whole);
    return {title: word, ...value, meaning: key?.meaning || value.meaning};
  }
  const value = listValues(path).find((one) => one.word === word);
  const key = path.at(-1);
  const about = typeof key === "string" ? describeValue(path) : {meaning: "", kinds: "", without: ""};
  if (value) return {title: word, meaning: value.meaning, kinds: "", without: "", of: key};
  if (!about.meaning && !about.kinds) return null;
  return {title: String(key), ...about};
}
