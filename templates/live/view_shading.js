// Surfaces as POV-Ray lights them, as far as a graphics card does it at once: lamps without shadows at each vertex,
// those with shadows and highlights at each pixel, the first of them with a soft shadow.
//
// Source: POV-Ray 3.7 reference manual, 3.4.6.3 (finish); M. Vogel, "A better way to construct the sunflower head" (1979)
// for the places at which the shadow is asked.
import {
  DataTexture, DoubleSide, CustomBlending, OneFactor, OneMinusSrcAlphaFactor, AddEquation, Matrix4, RawShaderMaterial,
  RGBFormat, UnsignedByteType, Vector3, Vector4, NoBlending,
} from "./lib/three.module.js";

export const kMostSoft = 24, kMostHard = 4, kMostCards = 4;
const kShadowPlaces = 8;

const kCommon = `
precision highp float;
uniform vec3 uEye;        // mm; of a flat camera the way toward it
uniform float uIsFlat;
vec3 findToEye(vec3 at) { return uIsFlat > 0.5 ? uEye : normalize(uEye - at); }
`;

const kVertex = `${kCommon}
attribute vec4 position, normal, colour;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform vec3 uSoftAt[${kMostSoft}], uSoftColour[${kMostSoft}], uSoftFade[${kMostSoft}];
uniform int uSoftCount;
uniform float uBrilliance;
varying vec3 vAt, vNormal, vSoft;
varying vec4 vColour;
void main() {
  vec4 at = modelMatrix * vec4(position.xyz, 1.0);
  vAt = at.xyz;
  vNormal = normalize(mat3(modelMatrix) * normal.xyz);
  vColour = colour;
  vec3 facing = dot(vNormal, findToEye(vAt)) < 0.0 ? -vNormal : vNormal;
  vSoft = vec3(0.0);
  for (int i = 0; i < ${kMostSoft}; ++i) {
    if (i >= uSoftCount) break;
    vec3 away = uSoftAt[i] - vAt;
    float along = length(away), cosine = dot(away, facing) / along;
    if (cosine <= 0.0) continue;
    float fade = uSoftFade[i].y > 0.0 ? 2.0 / (1.0 + pow(along / uSoftFade[i].x, uSoftFade[i].y)) : 1.0;
    vSoft += uSoftColour[i] * fade * (uBrilliance == 1.0 ? cosine : uBrilliance == 0.0 ? 1.0 : pow(cosine, uBrilliance));
  }
  gl_Position = projectionMatrix * viewMatrix * at;
}`;

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
varying vec3 vAt, vNormal, vSoft;
varying vec4 vColour;

float readDepth(vec2 at) {
  return dot(texture2D(uShadow, at), vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0));
}
float findVisible(vec3 normal) {
  if (uShadowSize.w < 0.5) return 1.0;
  vec4 in_lamp = uShadowFromWorld * vec4(vAt + normal * 0.9, 1.0);
  vec3 place = in_lamp.xyz / in_lamp.w * 0.5 + 0.5;
  if (place.x < 0.0 || place.x > 1.0 || place.y < 0.0 || place.y > 1.0) return 1.0;
  float depth = (in_lamp.w - uShadowSize.x) / (uShadowSize.y - uShadowSize.x);
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float seen = 0.0;
  for (int i = 0; i < ${kShadowPlaces}; ++i) {
    float radius = sqrt((float(i) + 0.5) / float(${kShadowPlaces})), angle = float(i) * 2.3999632 + turn;
    vec2 aside = uShadowSize.z * radius * vec2(cos(angle), sin(angle));
    seen += readDepth(place.xy + aside) + 0.0015 < depth ? 0.0 : 1.0;
  }
  return seen / float(${kShadowPlaces});
}
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
vec3 encode(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), light));
}
void main() {
  vec3 to_eye = findToEye(vAt), normal = normalize(vNormal);
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  vec3 rgb = vColour.rgb * vColour.rgb;
  float through = vColour.a;
  vec3 sum = (1.0 - through) * rgb * (uEmission + uDiffuse * vSoft);
  float visible = findVisible(normal);
  for (int i = 0; i < ${kMostHard}; ++i) {
    if (i >= uHardCount) break;
    vec3 away = uHardAt[i] - vAt;
    float along = length(away), cosine = dot(away, normal) / along;
    if (cosine <= 0.0) continue;
    vec3 light = uHardColour[i] * (i == 0 ? visible : 1.0);
    if (uHardFade[i].y > 0.0) light *= 2.0 / (1.0 + pow(along / uHardFade[i].x, uHardFade[i].y));
    sum += (1.0 - through) * rgb * uDiffuse * light *
           (uBrilliance == 1.0 ? cosine : uBrilliance == 0.0 ? 1.0 : pow(cosine, uBrilliance));
    vec3 to_lamp = away / along;
    float strength = 0.0;
    if (uSpecular > 0.0) strength += uSpecular * pow(max(dot(normalize(to_lamp + to_eye), normal), 0.0), 1.0 / uRoughness);
    if (uPhong > 0.0) strength += uPhong * pow(max(dot(reflect(-to_eye, normal), to_lamp), 0.0), uPhongSize);
    if (strength > 0.0) {
      float x = 2.0 * acos(clamp(cosine, 0.0, 1.0)) / 3.14159265 - 1.12;
      float fresnel = clamp(0.014567225 / (x * x) - 0.011612903, 0.0, 1.0);
      sum += strength * light * (1.0 + uMetallic * (1.0 - fresnel) * (rgb - 1.0));
    }
  }
  if (uReflection > 0.0) sum += findMirrored(to_eye, normal);
  gl_FragColor = vec4(encode(sum), 1.0 - through);
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
    uSoftAt: vectors(kMostSoft), uSoftColour: vectors(kMostSoft), uSoftFade: vectors(kMostSoft), uSoftCount: {value: 0},
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

/** The lamps and cards of a stage. Returns the lamp whose shadow is to be drawn, or null. */
export function setLight(light, stage) {
  const hard = sortHard(stage.lamps);
  const soft = stage.lamps.filter((lamp) => !hard.includes(lamp)).slice(0, kMostSoft);
  const fill = (name, lamps) => lamps.forEach((lamp, i) => {
    light[`${name}At`].value[i].fromArray(lamp.at);
    light[`${name}Colour`].value[i].fromArray(lamp.colour);
    light[`${name}Fade`].value[i].set(lamp.fade_distance, lamp.fade_power, 0);
  });
  fill("uSoft", soft);
  fill("uHard", hard);
  light.uSoftCount.value = soft.length;
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

/** The material of a part. */
export function createSurface(light, part) {
  const finish = part.finish;
  const blending = part.is_clear
    ? {transparent: true, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor,
       blendDst: OneMinusSrcAlphaFactor, depthWrite: false}
    : {blending: NoBlending};
  return new RawShaderMaterial({
    vertexShader: kVertex, fragmentShader: kFragment, side: DoubleSide, ...blending,
    uniforms: {
      ...light,
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
                                uniforms: {...light, uBrilliance: {value: 1}, uColour: {value: new Vector4().fromArray(rgba)}}});
}

/** The colours of areas over the skin. */
export function createTintMaterial() {
  return new RawShaderMaterial({vertexShader: kTintVertex, fragmentShader: kTintFragment, transparent: true, depthWrite: false,
                                polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2});
}
