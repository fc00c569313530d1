// SPDX-License-Identifier: GPL-3.0-or-later
// The decoder of model/codec, in WebAssembly: app/web/decoder/decoder.cpp.

/// An error by its name in model/base/error.h, or one of this page's own.
export interface NamedError {
    name: string;
    args: string[];
    /// Byte of the file at fault, -1 for none.
    offset: number;
}

export class DecodeError extends Error {
    constructor(readonly error: NamedError) {
        super(error.name);
    }
}

interface Exports {
    memory: WebAssembly.Memory;
    _initialize(): void;
    start(): void;
    input(size: number): number;
    append(): number;
    finish(): number;
    check(): number;
    errorName(): number;
    errorArgumentCount(): number;
    errorArgument(index: number): number;
    errorOffset(): number;
    hasHeader(): number;
    codec(): number;
    vertexCount(): number;
    triangleCount(): number;
    frameCount(): number;
    frameRate(): number;
    animationName(): number;
    linear(): number;
    bytesRead(): number;
    bandCount(): number;
    bandsInFile(): number;
    playable(): number;
    show(): void;
    keepsOrder(): number;
    rank(): number;
    layerCount(): number;
    array(): number;
    arrayLength(): number;
    coefficients(layer: number): void;
    basis(): void;
    frame(index: number): void;
    triangles(): void;
    edges(): void;
    cornerRanges(): void;
    corners(): void;
    bounds(count: number): void;
}

export interface Header {
    codec: number;
    vertexCount: number;
    triangleCount: number;
    frameCount: number;
    frameRate: number;
    name: string;
    /// Frames are sums of trajectories: the GPU computes them.
    isLinear: boolean;
}

const badDescriptor = () => 8; // of WASI: there are no files

/// Opens one file; another one takes another Decoder.
export class Decoder {
    private readonly wasm: Exports;

    constructor(module: WebAssembly.Module) {
        const outOfMemory = () => {
            throw new DecodeError({ name: 'OutOfMemory', args: [], offset: -1 });
        };
        const instance = new WebAssembly.Instance(module, {
            page: { outOfMemory },
            wasi_snapshot_preview1: { fd_close: badDescriptor, fd_seek: badDescriptor, fd_write: badDescriptor },
        });
        this.wasm = instance.exports as unknown as Exports;
        this.wasm._initialize();
        this.wasm.start();
    }

    /// Takes the next bytes of the file. Throws DecodeError.
    append(bytes: Uint8Array): void {
        const address = this.wasm.input(bytes.length);
        new Uint8Array(this.wasm.memory.buffer, address, bytes.length).set(bytes);
        this.require(this.wasm.append());
    }
    /// The file ends here. Throws DecodeError.
    finish(): void {
        this.require(this.wasm.finish());
    }
    /// Decodes what opening left for later. Throws DecodeError.
    check(): void {
        this.require(this.wasm.check());
    }

    header(): Header | null {
        const w = this.wasm;
        if (!w.hasHeader()) return null;
        return {
            codec: w.codec(),
            vertexCount: w.vertexCount(),
            triangleCount: w.triangleCount(),
            frameCount: w.frameCount(),
            frameRate: w.frameRate(),
            name: this.text(w.animationName()),
            isLinear: w.linear() !== 0,
        };
    }
    get bytesRead(): number {
        return this.wasm.bytesRead();
    }
    get bandCount(): number {
        return this.wasm.bandCount();
    }
    get bandsInFile(): number {
        return this.wasm.bandsInFile();
    }
    get isPlayable(): boolean {
        return this.wasm.playable() !== 0;
    }

    /// What is there becomes what the calls below tell of.
    show(): void {
        this.wasm.show();
    }
    get keepsOrder(): boolean {
        return this.wasm.keepsOrder() !== 0;
    }
    get rank(): number {
        return this.wasm.rank();
    }
    get layerCount(): number {
        return this.wasm.layerCount();
    }
    coefficients(layer: number): Float32Array<ArrayBuffer> {
        this.wasm.coefficients(layer);
        return this.floats();
    }
    basis(): Float32Array<ArrayBuffer> {
        this.wasm.basis();
        return this.floats();
    }
    frame(index: number): Float32Array<ArrayBuffer> {
        this.wasm.frame(index);
        return this.floats();
    }
    /// Centre, least and greatest corner of a box around some frames.
    bounds(frames: number): Float32Array<ArrayBuffer> {
        this.wasm.bounds(frames);
        return this.floats();
    }
    triangles(): Uint32Array<ArrayBuffer> {
        this.wasm.triangles();
        return this.integers();
    }
    edges(): Uint32Array<ArrayBuffer> {
        this.wasm.edges();
        return this.integers();
    }
    cornerRanges(): Uint32Array<ArrayBuffer> {
        this.wasm.cornerRanges();
        return this.integers();
    }
    corners(): Uint32Array<ArrayBuffer> {
        this.wasm.corners();
        return this.integers();
    }

    // Copies: the memory of the module moves when it grows.
    private floats(): Float32Array<ArrayBuffer> {
        return new Float32Array(this.wasm.memory.buffer, this.wasm.array(), this.wasm.arrayLength()).slice() as Float32Array<ArrayBuffer>;
    }
    private integers(): Uint32Array<ArrayBuffer> {
        return new Uint32Array(this.wasm.memory.buffer, this.wasm.array(), this.wasm.arrayLength()).slice() as Uint32Array<ArrayBuffer>;
    }

    private text(address: number): string {
        const bytes = new Uint8Array(this.wasm.memory.buffer, address);
        return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
    }

    private require(isGood: number): void {
        if (isGood) return;
        const args: string[] = [];
        for (let i = 0; i < this.wasm.errorArgumentCount(); ++i) args.push(this.text(this.wasm.errorArgument(i)));
        throw new DecodeError({ name: this.text(this.wasm.errorName()), args, offset: this.wasm.errorOffset() });
    }
}
