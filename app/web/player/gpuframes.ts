// SPDX-License-Identifier: GPL-3.0-or-later
// Frames on the GPU: coefficients lie in a texture; a frame costs the page one row of the basis, then the GPU computes
// all positions, and the normals from them. Frames that come decoded go into the same texture.
import * as THREE from 'three';
import type { Mesh } from './messages';
import { cover, normalsPass, positionsPass } from './shaders';

// As app/web/decoder/texturelayout.h has them.
const VertexColumns = 1024;
const CornerColumns = 2048;

/// What the GPU cannot hold.
export class TooLarge extends Error {}

function integerTexture(data: Uint32Array<ArrayBuffer>, columns: number): THREE.DataTexture {
    const texture = new THREE.DataTexture(data, columns, data.length / 2 / columns, THREE.RGIntegerFormat, THREE.UnsignedIntType);
    texture.internalFormat = 'RG32UI';
    texture.needsUpdate = true;
    return texture;
}

function passMaterial(fragmentShader: string, uniforms: Record<string, THREE.IUniform>): THREE.RawShaderMaterial {
    return new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3, vertexShader: cover, fragmentShader, uniforms, depthTest: false, depthWrite: false,
        blending: THREE.NoBlending,
    });
}

export class GpuFrames {
    readonly vertexCount: number;
    private readonly rows: number;
    private readonly positionsTarget: THREE.WebGLRenderTarget;
    private readonly normalsTarget: THREE.WebGLRenderTarget;
    private readonly ranges: THREE.DataTexture;
    private readonly corners: THREE.DataTexture;
    private readonly positionsMaterial: THREE.RawShaderMaterial;
    private readonly normalsMaterial: THREE.RawShaderMaterial;
    private readonly quad: THREE.Mesh<THREE.BufferGeometry, THREE.RawShaderMaterial>;
    private readonly passScene = new THREE.Scene();
    private readonly passCamera = new THREE.Camera();
    private coefficients: THREE.DataArrayTexture | null = null;
    private basis: THREE.DataTexture | null = null;
    private basisRows = new Float32Array(0);
    private texels: THREE.DataTexture | null = null;

    constructor(private readonly renderer: THREE.WebGLRenderer, mesh: Mesh) {
        this.vertexCount = mesh.vertexCount;
        this.rows = Math.ceil(mesh.vertexCount / VertexColumns);
        const most = renderer.capabilities.maxTextureSize;
        if (Math.max(this.rows, mesh.corners.length / 2 / CornerColumns) > most) throw new TooLarge();
        const target = () =>
            new THREE.WebGLRenderTarget(VertexColumns, this.rows, {
                format: THREE.RGBAIntegerFormat, type: THREE.UnsignedIntType, internalFormat: 'RGBA32UI',
                minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, depthBuffer: false, generateMipmaps: false,
            });
        this.positionsTarget = target();
        this.normalsTarget = target();
        this.ranges = integerTexture(mesh.cornerRanges, VertexColumns);
        this.corners = integerTexture(mesh.corners, CornerColumns);
        this.positionsMaterial = passMaterial(positionsPass, {
            coefficients: { value: null }, basis: { value: null }, layers: { value: 0 },
        });
        this.normalsMaterial = passMaterial(normalsPass, {
            positions: { value: this.positionsTarget.texture }, cornerRanges: { value: this.ranges },
            corners: { value: this.corners }, scale: { value: 1 },
        });
        const triangle = new THREE.BufferGeometry();
        triangle.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
        this.quad = new THREE.Mesh(triangle, this.positionsMaterial);
        this.quad.frustumCulled = false;
        this.passScene.add(this.quad);
    }

    /// What the shaders that draw read.
    get positions(): THREE.Texture {
        return this.texels ?? this.positionsTarget.texture;
    }
    get normals(): THREE.Texture {
        return this.normalsTarget.texture;
    }

    setSize(diagonal: number): void {
        this.normalsMaterial.uniforms.scale.value = diagonal > 0 ? 1000 / diagonal : 1;
    }

    /// Layers from `first` on; those before stay.
    setLinear(rows: Float32Array<ArrayBuffer>, frameCount: number, first: number, layers: Float32Array<ArrayBuffer>[]): void {
        const layerCount = first + layers.length;
        const layerValues = 4 * VertexColumns * this.rows;
        const data = new Float32Array(layerValues * Math.max(layerCount, 1));
        if (this.coefficients) data.set((this.coefficients.image.data as Float32Array).subarray(0, layerValues * first));
        layers.forEach((layer, i) => data.set(layer, layerValues * (first + i)));
        this.coefficients?.dispose();
        this.coefficients = new THREE.DataArrayTexture(data, VertexColumns, this.rows, Math.max(layerCount, 1));
        this.coefficients.format = THREE.RGBAFormat;
        this.coefficients.type = THREE.FloatType;
        this.coefficients.internalFormat = 'RGBA32F';
        this.coefficients.needsUpdate = true;
        this.basisRows = rows;
        const rowTexels = rows.length / 4 / frameCount;
        this.basis?.dispose();
        this.basis = new THREE.DataTexture(new Float32Array(4 * rowTexels), rowTexels, 1, THREE.RGBAFormat, THREE.FloatType);
        const uniforms = this.positionsMaterial.uniforms;
        uniforms.coefficients.value = this.coefficients;
        uniforms.basis.value = this.basis;
        uniforms.layers.value = layerCount;
    }

    /// Computes a frame of what setLinear() brought.
    evaluate(frame: number): void {
        if (!this.basis) return;
        const row = this.basis.image.data as unknown as Float32Array;
        row.set(this.basisRows.subarray(frame * row.length, (frame + 1) * row.length));
        this.basis.needsUpdate = true;
        this.pass(this.positionsMaterial, this.positionsTarget);
        this.pass(this.normalsMaterial, this.normalsTarget);
    }

    /// Shows a frame that came decoded.
    setTexels(texels: Float32Array<ArrayBuffer>): void {
        const bits = new Uint32Array(texels.buffer);
        if (!this.texels) {
            this.texels = new THREE.DataTexture(bits, VertexColumns, this.rows, THREE.RGBAIntegerFormat, THREE.UnsignedIntType);
            this.texels.internalFormat = 'RGBA32UI';
            this.normalsMaterial.uniforms.positions.value = this.texels;
        } else {
            (this.texels.image as { data: Uint32Array }).data = bits;
        }
        this.texels.needsUpdate = true;
        this.pass(this.normalsMaterial, this.normalsTarget);
    }

    /// The positions as the GPU has them, 4 floats a vertex; for tests.
    read(): Float32Array {
        if (this.texels) return new Float32Array((this.texels.image.data as unknown as Uint32Array).slice().buffer).subarray(0, 4 * this.vertexCount);
        const bits = new Uint32Array(4 * VertexColumns * this.rows);
        this.renderer.readRenderTargetPixels(this.positionsTarget, 0, 0, VertexColumns, this.rows, bits);
        return new Float32Array(bits.buffer).subarray(0, 4 * this.vertexCount);
    }

    dispose(): void {
        for (const thing of [this.positionsTarget, this.normalsTarget, this.ranges, this.corners, this.positionsMaterial,
                             this.normalsMaterial, this.quad.geometry, this.coefficients, this.basis, this.texels])
            thing?.dispose();
    }

    private pass(material: THREE.RawShaderMaterial, target: THREE.WebGLRenderTarget): void {
        const { renderer } = this;
        const isXr = renderer.xr.enabled;
        const clears = renderer.autoClear;
        const before = renderer.getRenderTarget();
        renderer.xr.enabled = false;
        renderer.autoClear = false;
        this.quad.material = material;
        renderer.setRenderTarget(target);
        renderer.render(this.passScene, this.passCamera);
        renderer.setRenderTarget(before);
        renderer.xr.enabled = isXr;
        renderer.autoClear = clears;
    }
}
