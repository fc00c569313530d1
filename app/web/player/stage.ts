// SPDX-License-Identifier: GPL-3.0-or-later
// The picture: camera, light and the three ways to draw, in the editor's colours. Draws when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GpuFrames } from './gpuframes';
import type { Bounds, Mesh } from './messages';
import { backgroundFragment, cover, drawVertex, linesFragment, pointsFragment, surfaceFragment } from './shaders';

export type DrawStyle = 'shaded' | 'wireframe' | 'points';

// As views/viewport/scenerenderer.cpp.
const Colors = {
    dark: { surface: 0xdebc8a, backSide: 0x7086a8, wire: 0xeccd9e, top: 0x424b5a, bottom: 0x15181e },
    light: { surface: 0xd6ac74, backSide: 0x7086a8, wire: 0x463420, top: 0xfafbfd, bottom: 0xbac2ce },
};
const WireAlpha = 0.86;
const PointSize = 3.5; // CSS pixels
const FieldOfView = 35; // degrees
const MostPixelRatio = 2;

export class Stage {
    readonly renderer: THREE.WebGLRenderer;
    readonly scene = new THREE.Scene();
    readonly camera = new THREE.PerspectiveCamera(FieldOfView, 1, 0.01, 100);
    /// What holds the mesh: an immersive view moves it to where a person stands.
    readonly holder = new THREE.Group();
    frames: GpuFrames | null = null;

    private readonly controls: OrbitControls;
    private readonly backdrop: THREE.Mesh<THREE.BufferGeometry, THREE.RawShaderMaterial>;
    private readonly surface: THREE.RawShaderMaterial;
    private readonly depthOnly: THREE.RawShaderMaterial;
    private readonly dots: THREE.RawShaderMaterial;
    private readonly lines: THREE.RawShaderMaterial;
    private readonly shared: Record<string, THREE.IUniform> = {
        positions: { value: null }, normals: { value: null }, pointSize: { value: PointSize },
        surface: { value: new THREE.Color() }, backSide: { value: new THREE.Color() },
        line: { value: new THREE.Vector4() },
    };
    private solid: THREE.Mesh | null = null;
    private wire: THREE.LineSegments | null = null;
    private cloud: THREE.Points | null = null;
    private bounds: Bounds | null = null;
    private wasMoved = false;
    private isDirty = true;
    private isWarm = false;
    private style: DrawStyle = 'shaded';
    private density = 1;

    constructor(canvas: HTMLCanvasElement) {
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
        this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // the shaders encode
        this.renderer.xr.enabled = true;
        this.surface = this.material(drawVertex, surfaceFragment, { side: THREE.DoubleSide });
        this.depthOnly = this.material(drawVertex, surfaceFragment,
                                       { side: THREE.DoubleSide, colorWrite: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
        this.dots = this.material(drawVertex, pointsFragment, {});
        this.lines = this.material(drawVertex, linesFragment, { transparent: true });
        this.backdrop = this.makeBackdrop();
        this.scene.add(this.backdrop, this.holder);
        this.camera.position.set(1, 0.6, 1.4);

        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.addEventListener('change', () => this.invalidate());
        this.controls.addEventListener('start', () => (this.wasMoved = true));
        new ResizeObserver(() => this.resize()).observe(canvas.parentElement!);
        this.resize();
    }


    invalidate(): void {
        this.isDirty = true;
    }

    setDark(isDark: boolean): void {
        const colors = isDark ? Colors.dark : Colors.light;
        // Colours are linear in three.js, as the shaders want them.
        this.shared.surface.value.set(colors.surface);
        this.shared.backSide.value.set(colors.backSide);
        const wire = new THREE.Color(colors.wire);
        this.shared.line.value.set(wire.r, wire.g, wire.b, WireAlpha);
        this.backdrop.material.uniforms.top.value.set(colors.top);
        this.backdrop.material.uniforms.bottom.value.set(colors.bottom);
        this.invalidate();
    }

    clear(): void {
        for (const part of [this.solid, this.wire, this.cloud]) {
            part?.geometry.dispose();
            part?.removeFromParent();
        }
        this.holder.clear();
        this.solid = this.wire = this.cloud = null;
        this.frames?.dispose();
        this.frames = null;
        this.bounds = null;
        this.wasMoved = false;
        this.invalidate();
    }

    /// Has the GPU's driver compile all shaders, on a mesh of nothing, while a file is still being decoded.
    warmUp(): void {
        if (this.isWarm) return;
        this.isWarm = true;
        this.setMesh({ vertexCount: 1, triangles: new Uint32Array(3), cornerRanges: new Uint32Array(2 * 1024), corners: new Uint32Array(2 * 2048) });
        this.frames!.setLinear(new Float32Array(4 * 5), 1, 0, [new Float32Array(4 * 1024)]);
        this.frames!.evaluate(0);
        this.setEdges(new Uint32Array(2));
        for (const part of [this.solid!, this.wire!, this.cloud!]) part.visible = true;
        this.draw();
        this.clear();
    }

    /// Throws TooLarge. What is shown comes with the first frame.
    setMesh(mesh: Mesh): void {
        const frames = new GpuFrames(this.renderer, mesh);
        const bounds = this.bounds, wasMoved = this.wasMoved;
        this.clear();
        this.bounds = bounds;
        this.wasMoved = wasMoved;
        this.frames = frames;
        if (bounds) this.setBounds(bounds);

        const solid = new THREE.BufferGeometry();
        solid.setIndex(new THREE.BufferAttribute(mesh.triangles, 1));
        this.solid = this.part(new THREE.Mesh(solid, this.surface));
        const cloud = new THREE.BufferGeometry();
        cloud.setIndex(new THREE.BufferAttribute(shuffled(mesh.vertexCount), 1));
        this.cloud = this.part(new THREE.Points(cloud, this.dots));
        this.applyStyle();
    }

    get needsEdges(): boolean {
        return this.style === 'wireframe' && this.frames !== null && this.wire === null;
    }

    setEdges(edges: Uint32Array<ArrayBuffer>): void {
        const geometry = new THREE.BufferGeometry();
        geometry.setIndex(new THREE.BufferAttribute(edges, 1));
        this.wire = this.part(new THREE.LineSegments(geometry, this.lines));
        this.wire.renderOrder = 1;
        this.applyStyle();
    }

    setStyle(style: DrawStyle): void {
        this.style = style;
        this.applyStyle();
    }

    /// The share of the vertices that are drawn as points, spread evenly. 0 ... 1
    setDensity(density: number): void {
        this.density = density;
        this.applyStyle();
    }

    setBounds(bounds: Bounds): void {
        this.bounds = bounds;
        this.frames?.setSize(this.diagonal);
        if (!this.wasMoved) this.fit();
    }

    get diagonal(): number {
        return this.bounds ? new THREE.Vector3(...this.bounds.most).distanceTo(new THREE.Vector3(...this.bounds.least)) : 1;
    }
    get middle(): THREE.Vector3 {
        return this.bounds ? new THREE.Vector3(...this.bounds.most).add(new THREE.Vector3(...this.bounds.least)).multiplyScalar(0.5)
                           : new THREE.Vector3();
    }
    get lowest(): number {
        return this.bounds ? this.bounds.least[1] : 0;
    }

    /// Shows everything from the editor's first point of view.
    fit(): void {
        const radius = Math.max(this.diagonal / 2, 1e-30);
        const half = THREE.MathUtils.degToRad(FieldOfView / 2);
        const narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
        const distance = (1.02 * radius) / Math.sin(narrow);
        const yaw = THREE.MathUtils.degToRad(35), pitch = THREE.MathUtils.degToRad(20);
        const direction = new THREE.Vector3(Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch));
        this.controls.target.copy(this.middle);
        this.camera.position.copy(this.middle).addScaledVector(direction, distance);
        this.controls.minDistance = radius * 0.02;
        this.controls.maxDistance = radius * 40;
        this.controls.update();
        this.wasMoved = false;
        this.invalidate();
    }

    /// Turns around the middle, radians; zooms by a factor.
    move(yaw: number, pitch: number, zoom: number): void {
        const offset = this.camera.position.clone().sub(this.controls.target);
        const place = new THREE.Spherical().setFromVector3(offset);
        place.theta += yaw;
        place.phi = THREE.MathUtils.clamp(place.phi + pitch, 0.02, Math.PI - 0.02);
        place.radius = THREE.MathUtils.clamp(place.radius / zoom, this.controls.minDistance, this.controls.maxDistance);
        this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(place));
        this.controls.update();
        this.wasMoved = true;
        this.invalidate();
    }

    /// Draws if anything has changed.
    draw(): void {
        const isImmersive = this.renderer.xr.isPresenting;
        if (!this.isDirty && !isImmersive) return;
        this.isDirty = false;
        this.shared.positions.value = this.frames?.positions ?? null;
        this.shared.normals.value = this.frames?.normals ?? null;
        this.backdrop.visible = !isImmersive;
        const distance = this.camera.position.distanceTo(this.controls.target);
        if (!isImmersive) {
            this.camera.near = Math.max(distance - this.diagonal * 1.5, distance * 0.01);
            this.camera.far = distance + this.diagonal * 2;
            this.camera.updateProjectionMatrix();
        }
        this.renderer.render(this.scene, this.camera);
    }

    private material(vertexShader: string, fragmentShader: string, more: THREE.ShaderMaterialParameters): THREE.RawShaderMaterial {
        return new THREE.RawShaderMaterial({ glslVersion: THREE.GLSL3, vertexShader, fragmentShader, uniforms: this.shared, ...more });
    }

    private makeBackdrop(): THREE.Mesh<THREE.BufferGeometry, THREE.RawShaderMaterial> {
        const triangle = new THREE.BufferGeometry();
        triangle.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        const backdrop = new THREE.Mesh(triangle, new THREE.RawShaderMaterial({
            glslVersion: THREE.GLSL3, vertexShader: cover, fragmentShader: backgroundFragment, depthTest: false, depthWrite: false,
            uniforms: { top: { value: new THREE.Color() }, bottom: { value: new THREE.Color() }, size: { value: new THREE.Vector2(1, 1) } },
        }));
        backdrop.frustumCulled = false;
        backdrop.renderOrder = -1;
        return backdrop;
    }

    private part<Part extends THREE.Object3D>(object: Part): Part {
        object.frustumCulled = false; // where the vertices are only the GPU knows
        this.holder.add(object);
        return object;
    }

    private applyStyle(): void {
        if (!this.solid || !this.cloud || !this.frames) return;
        const isWire = this.style === 'wireframe' && this.wire !== null;
        this.solid.visible = this.style !== 'points';
        this.solid.material = isWire ? this.depthOnly : this.surface;
        if (this.wire) this.wire.visible = isWire;
        // A mesh without triangles is a cloud in every style.
        this.cloud.visible = this.style === 'points' || this.solid.geometry.index!.count === 0;
        this.cloud.geometry.setDrawRange(0, Math.max(1, Math.round(this.density * this.frames.vertexCount)));
        this.invalidate();
    }

    private resize(): void {
        const parent = this.renderer.domElement.parentElement!;
        const width = Math.max(parent.clientWidth, 1), height = Math.max(parent.clientHeight, 1);
        if (this.renderer.xr.isPresenting) return;
        const ratio = Math.min(window.devicePixelRatio, MostPixelRatio);
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.camera.aspect = width / height;
        this.camera.updateProjectionMatrix();
        this.shared.pointSize.value = PointSize * ratio;
        this.backdrop.material.uniforms.size.value.set(width * ratio, height * ratio);
        if (this.bounds && !this.wasMoved) this.fit();
        this.invalidate();
    }
}

/// 0 ... count - 1 in an order in which every beginning is spread over all; always the same.
function shuffled(count: number): Uint32Array<ArrayBuffer> {
    const order = new Uint32Array(count);
    let random = 1;
    for (let i = 0; i < count; ++i) {
        random = (Math.imul(random, 1664525) + 1013904223) >>> 0;
        const j = Math.floor((random / 2 ** 32) * (i + 1));
        order[i] = order[j];
        order[j] = i;
    }
    return order;
}
