// Surfaces as POV-Ray lights them, as far as a graphics card does it at once: lamps without shadows from a table of
// directions, as they are far off; those with shadows and highlights one by one, the first with a soft shadow.
//
// Source: POV-Ray 3.7 reference manual, 3.4.6.3 (finish); M. Vogel, "A better way to construct the sunflower head" (1979)
// for the places at which the shadow is asked.
import {
  DataTexture, DoubleSide, CustomBlending, OneFactor, OneMinusSrcAlphaFactor, AddEquation, Matrix4, RawShaderMaterial,
  LinearFilter, NoBlending, RGBAFormat, RGBFormat, UnsignedByteType, Vector3, Vector4,
} from "./lib/three.module.js";

const kMostHard = 4, kMostCards = 4;
const kTable = 32;           // directions of the table: its side
const kTableMost = 4;        // light that the table holds at most
const kShadowPlaces = 8;

const kCommon = `
precision highp float;
uniform vec3 uEye;        // mm; of a flat camera the way toward it
uniform float uIsFlat;
vec3 findToEye(vec3 at) { return uIsFlat > 0.5 ? uEye : normalize(uEye - at); }
`;

const kVertex = `
precision highp float;
attribute vec4 position, normal, colour;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
varying vec3 vAt, vNormal;
varying vec4 vColour;
void main() {
  vec4 at = modelMatrix * vec4(position.xyz, 1.0);
  vAt = at.xyz;
  vNormal = mat3(modelMatrix) * normal.xyz;
  vColour = colour;
  gl_Position = projectionMatrix * viewMatrix * at;
}`;

// Of what a part has none, nothing is compiled: without a graphics card each word of this costs. QUICK is for a face that
// moves on such a machine: no highlights, and a hard shadow.
const kFragment = `${kCommon}
uniform vec3 uHardAt[${kMostHard}], uHardColour[${kMostHard}], uHardFade[${kMostHard}];
uniform int uHardCount;
uniform sampler2D uShadow;
uniform mat4 uShadowFromWorld;
uniform vec4 uShadowSize;   // near, far (mm), how soft it is, 1 if there is one
uniform float uDiffuse, uBrilliance, uSpecular, uRoughness, uPhong, uPhongSize, uMetallic, uReflection;
uniform vec3 uEmission;
uniform int uCardCount;
uniform mat4 uCardFromWorld[${kMostCards}];
uniform vec3 uCardLow[${kMostCards}], uCardHigh[${kMostCards}], uCardColour[${kMostCards}];
uniform float uCardIsBall[${kMostCards}];
uniform sampler2D uSoft;
varying vec3 vAt, vNormal;
varying vec4 vColour;

// Directions on a square: Q. Meyer et al., "On floating-point normal vectors" (2010).
vec3 findSoft(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 at = n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  vec3 root = texture2D(uSoft, at * ${(kTable - 1) / 2 / kTable} + 0.5).rgb;
  return ${kTableMost}.0 * root * root;
}
float readDepth(vec2 at) {
  return dot(texture2D(uShadow, at), vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0));
}
float findVisible(vec3 normal) {
  if (uShadowSize.w < 0.5) return 1.0;
  vec4 in_lamp = uShadowFromWorld * vec4(vAt + normal * 0.9, 1.0);
  vec3 place = in_lamp.xyz / in_lamp.w * 0.5 + 0.5;
  if (place.x < 0.0 || place.x > 1.0 || place.y < 0.0 || place.y > 1.0) return 1.0;
  float depth = (in_lamp.w - uShadowSize.x) / (uShadowSize.y - uShadowSize.x) - 0.0015;
#ifdef QUICK
  return readDepth(place.xy) < depth ? 0.0 : 1.0;
#else
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float seen = 0.0;
  for (int i = 0; i < ${kShadowPlaces}; ++i) {
    float radius = sqrt((float(i) + 0.5) / float(${kShadowPlaces})), angle = float(i) * 2.3999632 + turn;
    vec2 aside = uShadowSize.z * radius * vec2(cos(angle), sin(angle));
    seen += readDepth(place.xy + aside) < depth ? 0.0 : 1.0;
  }
  return seen / float(${kShadowPlaces});
#endif
}
#ifdef REFLECTION
vec3 findMirrored(vec3 to_eye, vec3 normal) {
  vec3 direction = reflect(-to_eye, normal), colour = vec3(0.0);
  float nearest = 1e9;
  for (int i = 0; i < ${kMostCards}; ++i) {
    if (i >= uCardCount) break;
    vec3 o = (uCardFromWorld[i] * vec4(vAt, 1.0)).xyz, d = (uCardFromWorld[i] * vec4(direction, 0.0)).xyz;
    float at = -1.0;
    if (uCardIsBall[i] > 0.5) {
      float a = dot(d, d), b = dot(o, d), root = b * b - a * (dot(o, o) - 1.0);
      if (root >= 0.0) at = (-b - sqrt(root)) / a;
    } else {
      vec3 one = (uCardLow[i] - o) / d, other = (uCardHigh[i] - o) / d;
      vec3 low = min(one, other), high = max(one, other);
      float first = max(max(low.x, low.y), low.z), last = min(min(high.x, high.y), high.z);
      if (first <= last) at = first;
    }
    if (at > 0.0 && at < nearest) {
      nearest = at;
      colour = uCardColour[i];
    }
  }
  return uReflection * colour;
}
#endif
float turnLight(float cosine) {
#if defined(PLAIN)
  return cosine;
#elif defined(FLAT)
  return 1.0;
#else
  return pow(cosine, uBrilliance);
#endif
}
float findHighlight(vec3 to_lamp, vec3 to_eye, vec3 normal) {
  float strength = 0.0;
#ifdef SPECULAR
  strength += uSpecular * pow(max(dot(normalize(to_lamp + to_eye), normal), 0.0), 1.0 / uRoughness);
#endif
#ifdef PHONG
  strength += uPhong * pow(max(dot(reflect(-to_eye, normal), to_lamp), 0.0), uPhongSize);
#endif
  return strength;
}
// sRGB without powers, to a thousandth. Source: I. Taylor, "Faster sRGB" (Chilliant, 2012).
vec3 encode(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  vec3 a = sqrt(light), b = sqrt(a), c = sqrt(b);
  return max(0.662002687 * a + 0.684122060 * b - 0.323583601 * c - 0.0225411470 * light, 0.0);
}
void main() {
  vec3 to_eye = findToEye(vAt), normal = normalize(vNormal);
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  vec3 rgb = vColour.rgb * vColour.rgb, diffuse = (1.0 - vColour.a) * uDiffuse * rgb;
  vec3 sum = (1.0 - vColour.a) * rgb * uEmission + diffuse * findSoft(normal);
#ifdef QUICK
  vec3 away = uHardAt[0] - vAt;
  float cosine = dot(away, normal) * inversesqrt(dot(away, away));
  if (cosine > 0.0) sum += diffuse * findVisible(normal) * uHardColour[0] * turnLight(cosine);
#else
  float visible = findVisible(normal);
  for (int i = 0; i < ${kMostHard}; ++i) {
    if (i >= uHardCount) break;
    vec3 away = uHardAt[i] - vAt;
    float along = length(away), cosine = dot(away, normal) / along;
    if (cosine <= 0.0) continue;
    vec3 light = uHardColour[i] * (i == 0 ? visible : 1.0);
    if (uHardFade[i].y > 0.0) light *= 2.0 / (1.0 + pow(along / uHardFade[i].x, uHardFade[i].y));
    sum += diffuse * light * turnLight(cosine);
    float strength = findHighlight(away / along, to_eye, normal);
#ifdef METALLIC
    float x = 2.0 * acos(clamp(cosine, 0.0, 1.0)) / 3.14159265 - 1.12;
    float fresnel = clamp(0.014567225 / (x * x) - 0.011612903, 0.0, 1.0);
    light *= 1.0 + uMetallic * (1.0 - fresnel) * (rgb - 1.0);
#endif
    sum += strength * light;
  }
#endif
#ifdef REFLECTION
  sum += findMirrored(to_eye, normal);
#endif
  gl_FragColor = vec4(encode(sum), 1.0 - vColour.a);
}`;

const kShadowVertex = `
precision highp float;
attribute vec4 position;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
varying float vAlong;
void main() {
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position.xyz, 1.0);
  vAlong = gl_Position.w;
}`;

const kShadowFragment = `
precision highp float;
uniform vec2 uRange;
varying float vAlong;
void main() {
  float depth = clamp((vAlong - uRange.x) / (uRange.y - uRange.x), 0.0, 0.99999);
  vec4 digits = fract(depth * vec4(1.0, 255.0, 65025.0, 16581375.0));
  gl_FragColor = digits - digits.yzww * vec4(1.0 / 255.0, 1.0 / 255.0, 1.0 / 255.0, 0.0);
}`;

const kFlatFragment = `
precision highp float;
uniform vec4 uColour;
varying vec3 vNormal, vAt;
uniform vec3 uEye;
void main() {
  float rim = 1.0 - abs(dot(normalize(vNormal), normalize(uEye - vAt)));
  gl_FragColor = vec4(uColour.rgb, uColour.a * (0.25 + 0.75 * rim));
}`;

const kTintVertex = `
precision highp float;
attribute vec4 position, tint;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
varying vec4 vTint;
void main() {
  vTint = tint;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position.xyz, 1.0);
}`;

const kTintFragment = `
precision highp float;
varying vec4 vTint;
void main() { gl_FragColor = vec4(vTint.rgb, 0.62 * vTint.a); }`;

const makeList = (count, make) => Array.from({length: count}, make);

/** What all surfaces of a view are lit with; the materials share these values. */
export function createLight() {
  const vectors = (count) => ({value: makeList(count, () => new Vector3())});
  const white = new DataTexture(new Uint8Array([255, 255, 255]), 1, 1, RGBFormat, UnsignedByteType);
  return {
    uEye: {value: new Vector3()}, uIsFlat: {value: 0},
    surfaces: new Map(), tables: new Map(), soft: [], middle: [0, 0, 0],  // of lamps without shadows, by brilliance
    uHardAt: vectors(kMostHard), uHardColour: vectors(kMostHard), uHardFade: vectors(kMostHard), uHardCount: {value: 0},
    uShadow: {value: white}, uShadowFromWorld: {value: new Matrix4()}, uShadowSize: {value: new Vector4()},
    uCardCount: {value: 0}, uCardFromWorld: {value: makeList(kMostCards, () => new Matrix4())},
    uCardLow: vectors(kMostCards), uCardHigh: vectors(kMostCards), uCardColour: vectors(kMostCards),
    uCardIsBall: {value: makeList(kMostCards, () => 0)},
  };
}

// Lamps with a cloth first: theirs is the shadow that is seen.
function sortHard(lamps) {
  const brightness = (lamp) => lamp.colour[0] + lamp.colour[1] + lamp.colour[2] + (Math.hypot(...lamp.side) > 0 ? 100 : 0);
  return lamps.filter((lamp) => lamp.has_shadow).sort((a, b) => brightness(b) - brightness(a)).slice(0, kMostHard);
}

// The light of all soft lamps on a surface that looks to a direction, in the middle of the stage.
function sumSoft(light, brilliance, normal, into) {
  into.fill(0);
  for (const {way, colour} of light.soft) {
    const cosine = way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2];
    if (cosine <= 0) continue;
    const turned = brilliance === 1 ? cosine : brilliance === 0 ? 1 : cosine ** brilliance;
    for (let k = 0; k < 3; ++k) into[k] += turned * colour[k];
  }
}

function fillTable(light, brilliance, texture) {
  const bytes = texture.image.data, sum = [0, 0, 0];
  for (let row = 0; row < kTable; ++row)
    for (let column = 0; column < kTable; ++column) {
      let x = 2 * column / (kTable - 1) - 1, y = 2 * row / (kTable - 1) - 1;
      const z = 1 - Math.abs(x) - Math.abs(y);
      if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x >= 0 ? 1 : -1), (1 - Math.abs(x)) * (y >= 0 ? 1 : -1)];
      const long = Math.hypot(x, y, z);
      sumSoft(light, brilliance, [x / long, y / long, z / long], sum);
      for (let k = 0; k < 3; ++k)
        bytes[4 * (kTable * row + column) + k] = Math.round(255 * Math.sqrt(Math.min(sum[k] / kTableMost, 1)));
    }
  texture.needsUpdate = true;
}

function findTable(light, brilliance) {
  if (!light.tables.has(brilliance)) {
    const texture = new DataTexture(new Uint8Array(4 * kTable * kTable).fill(255), kTable, kTable, RGBAFormat, UnsignedByteType);
    texture.minFilter = texture.magFilter = LinearFilter;
    light.tables.set(brilliance, texture);
    fillTable(light, brilliance, texture);
  }
  return light.tables.get(brilliance);
}

function setSoft(light, lamps, middle) {
  const soft = lamps.map((lamp) => {
    const away = lamp.at.map((x, k) => x - middle[k]), along = Math.hypot(...away);
    const fade = lamp.fade_power > 0 ? 2 / (1 + (along / lamp.fade_distance) ** lamp.fade_power) : 1;
    return {way: away.map((x) => x / along), colour: lamp.colour.map((c) => c * fade)};
  });
  if (JSON.stringify(soft) === JSON.stringify(light.soft)) return;
  light.soft = soft;
  for (const [brilliance, texture] of light.tables) fillTable(light, brilliance, texture);
}

/** The lamps and cards of a stage. Returns the lamp whose shadow is to be drawn, or null. */
export function setLight(light, stage) {
  const hard = sortHard(stage.lamps);
  setSoft(light, stage.lamps.filter((lamp) => !hard.includes(lamp)), stage.camera.look_at);
  hard.forEach((lamp, i) => {
    light.uHardAt.value[i].fromArray(lamp.at);
    light.uHardColour.value[i].fromArray(lamp.colour);
    light.uHardFade.value[i].set(lamp.fade_distance, lamp.fade_power, 0);
  });
  light.uHardCount.value = hard.length;
  const cards = stage.cards.slice(0, kMostCards);
  light.uCardCount.value = cards.length;
  cards.forEach((card, i) => {
    const m = card.card_from_place;
    light.uCardFromWorld.value[i].set(m[0], m[3], m[6], m[9], m[1], m[4], m[7], m[10], m[2], m[5], m[8], m[11], 0, 0, 0, 1);
    light.uCardLow.value[i].fromArray(card.low);
    light.uCardHigh.value[i].fromArray(card.high);
    light.uCardColour.value[i].fromArray(card.colour);
    light.uCardIsBall.value[i] = card.is_ball ? 1 : 0;
  });
  return hard[0] ?? null;
}

const listUniforms = (light) => Object.fromEntries(Object.entries(light).filter(([name]) => /^u[A-Z]/.test(name)));

/** The material of a part, one for all that look alike; `isQuick`: see kFragment. */
export function findSurface(light, part, isQuick) {
  const key = JSON.stringify([part.finish, part.is_clear, isQuick]);
  if (!light.surfaces.has(key)) light.surfaces.set(key, createSurface(light, part, isQuick));
  return light.surfaces.get(key);
}

function createSurface(light, part, isQuick) {
  const finish = part.finish;
  const defines = {};
  if (isQuick) defines.QUICK = 1;
  if (finish.brilliance === 1) defines.PLAIN = 1;
  if (finish.brilliance === 0) defines.FLAT = 1;
  for (const name of ["specular", "phong", "metallic", "reflection"]) if (finish[name] > 0) defines[name.toUpperCase()] = 1;
  const blending = part.is_clear
    ? {transparent: true, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor,
       blendDst: OneMinusSrcAlphaFactor, depthWrite: false}
    : {blending: NoBlending};
  return new RawShaderMaterial({
    vertexShader: kVertex, fragmentShader: kFragment, defines, side: DoubleSide, ...blending,
    uniforms: {
      ...listUniforms(light), uSoft: {value: findTable(light, finish.brilliance)},
      uDiffuse: {value: finish.diffuse}, uBrilliance: {value: finish.brilliance}, uSpecular: {value: finish.specular},
      uRoughness: {value: Math.max(finish.roughness, 1e-4)}, uPhong: {value: finish.phong}, uPhongSize: {value: finish.phong_size},
      uMetallic: {value: finish.metallic}, uReflection: {value: finish.reflection},
      uEmission: {value: new Vector3().fromArray(finish.emission)},
    },
  });
}

/** What the shadow's picture is drawn with: how far from the lamp, between `near` and `far`. */
export function createShadowMaterial() {
  return new RawShaderMaterial({vertexShader: kShadowVertex, fragmentShader: kShadowFragment, side: DoubleSide,
                                blending: NoBlending, uniforms: {uRange: {value: {x: 0, y: 1}}}});
}

/** A ghost: its rim is seen, its middle hardly. */
export function createGhostMaterial(light, rgba) {
  return new RawShaderMaterial({vertexShader: kVertex, fragmentShader: kFlatFragment, transparent: true, depthWrite: false,
                                uniforms: {...listUniforms(light), uColour: {value: new Vector4().fromArray(rgba)}}});
}

/** The colours of areas over the skin. */
export function createTintMaterial() {
  return new RawShaderMaterial({vertexShader: kTintVertex, fragmentShader: kTintFragment, transparent: true, depthWrite: false,
                                polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2});
}
