// The picture: camera, light, shadow and ground about the figures, drawn with WebGL.
import {
  BufferAttribute, BufferGeometry, DataTexture, LinearFilter, Mesh, NearestFilter, RawShaderMaterial, RGBAFormat, RGBFormat,
  Scene, UnsignedByteType, Vector3, WebGLRenderer, WebGLRenderTarget,
} from "./lib/three.module.js";
import {createLight, createShadowMaterial, setLight} from "./view_shading.js";
import {createCamera, setCamera, setLampCamera} from "./view_camera.js";
import {kCasting, kSeen} from "./view_figures.js";

const kShadow_px = 1024, kSoftwareShadow_px = 512;
const kCast_mm = 210;      // about the middle of the heads: what casts the shadow
const kSoftest = 0.012;    // of the shadow's picture
const kFrom_mm = 34;       // how far before the skin what shades it lies, mostly

function createGround() {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  const texture = new DataTexture(new Uint8Array([128, 128, 128]), 1, 1, RGBFormat, UnsignedByteType);
  const material = new RawShaderMaterial({
    vertexShader: `attribute vec2 position; varying vec2 vAt;
      void main() { vAt = position * 0.5 + 0.5; gl_Position = vec4(position, 1.0, 1.0); }`,
    fragmentShader: `precision mediump float; uniform sampler2D uSky; varying vec2 vAt;
      void main() { gl_FragColor = texture2D(uSky, vec2(vAt.x, 1.0 - vAt.y)); }`,
    uniforms: {uSky: {value: texture}}, depthTest: false, depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = -10;
  return mesh;
}

// Asked of a canvas of its own: how the real one's edges are smoothed depends on it.
function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl");
  const names = gl?.getExtension("WEBGL_debug_renderer_info");
  const is = Boolean(names) && /swiftshader|llvmpipe|software/i.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return is;
}

/** One canvas with what is drawn on it. */
export class Stage {
  constructor(canvas) {
    this.isSoftware = isSoftware();
    this.renderer = new WebGLRenderer({canvas, antialias: !this.isSoftware, preserveDrawingBuffer: true});
    this.renderer.autoClear = false;
    this.scene = new Scene();
    this.scene.autoUpdate = false;
    this.camera = createCamera();
    this.lamp = createCamera();
    this.light = createLight();
    this.ground = createGround();
    this.scene.add(this.ground);
    const side_px = this.isSoftware ? kSoftwareShadow_px : kShadow_px;
    this.shadow = new WebGLRenderTarget(side_px, side_px,
                                        {minFilter: NearestFilter, magFilter: NearestFilter, format: RGBAFormat});
    this.shadowMaterial = createShadowMaterial();
    this.caster = null;
  }

  /** What stands about the figures in a drawing (api/shapes). */
  setStage(stage) {
    this.caster = setLight(this.light, stage);
    this.middle = new Vector3().fromArray(stage.camera.look_at);
  }

  /** The ground as api/sky gives it. */
  setGround(width, height, bytes) {
    const texture = new DataTexture(bytes, width, height, RGBFormat, UnsignedByteType);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.unpackAlignment = 1;
    texture.needsUpdate = true;
    this.ground.material.uniforms.uSky.value.dispose();
    this.ground.material.uniforms.uSky.value = texture;
  }

  /** The shadow that the figures cast as they stand now. */
  drawShadow(figures) {
    const {uShadowSize, uShadowFromWorld, uShadow} = this.light;
    if (!this.caster) {
      uShadowSize.value.w = 0;
      return;
    }
    const {near, far, wide_mm} = setLampCamera(this.lamp, this.caster.at, this.middle, kCast_mm);
    const cloth = Math.hypot(...this.caster.side);
    const away = new Vector3().fromArray(this.caster.at).distanceTo(this.middle);
    uShadowSize.value.set(near, far, Math.min(cloth / away * kFrom_mm / wide_mm / 2 + 0.0012, kSoftest), 1);
    uShadowFromWorld.value.multiplyMatrices(this.lamp.projectionMatrix, this.lamp.matrixWorldInverse);
    this.shadowMaterial.uniforms.uRange.value = {x: near, y: far};
    this.lamp.layers.set(kCasting);
    this.scene.overrideMaterial = this.shadowMaterial;
    const visible = this.scene.children.map((child) => child.visible);
    for (const child of this.scene.children) child.visible = child === figures.group;
    figures.group.updateMatrixWorld(true);
    this.renderer.setRenderTarget(this.shadow);
    this.renderer.setClearColor(0xffffff, 1);
    this.renderer.clear();
    this.renderer.render(this.scene, this.lamp);
    this.renderer.setRenderTarget(null);
    this.scene.children.forEach((child, i) => { child.visible = visible[i]; });
    this.scene.overrideMaterial = null;
    uShadow.value = this.shadow.texture;
  }

  /** Until all that was asked for is drawn. */
  wait() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** Draws the picture into a part of the canvas: x, y, width and height in its pixels. */
  draw(said, orbit, part) {
    const {eye, isFlat} = setCamera(this.camera, said, orbit);
    this.light.uEye.value.copy(eye);
    this.light.uIsFlat.value = isFlat ? 1 : 0;
    this.camera.layers.set(kSeen);
    this.scene.updateMatrixWorld(true);
    this.renderer.setViewport(part.x, part.y, part.width, part.height);
    this.renderer.setScissor(part.x, part.y, part.width, part.height);
    this.renderer.setScissorTest(true);
    this.renderer.clear();
    this.renderer.render(this.scene, this.camera);
    this.renderer.setScissorTest(false);
  }
}
