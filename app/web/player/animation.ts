// SPDX-License-Identifier: GPL-3.0-or-later
// One opened file: its worker, and what has come from it.
import type { Header, NamedError } from './decoder';
import type { Bounds, FromWorker, Mesh, ToWorker } from './messages';

const FramesAhead = 6; // of a file that is decoded frame by frame

type Linear = Extract<FromWorker, { kind: 'linear' }>;
type Progress = Extract<FromWorker, { kind: 'progress' }>;

/// Calls back as things come, until close().
export interface AnimationListener {
    header(header: Header): void;
    mesh(mesh: Mesh): void;
    linear(linear: Linear): void;
    bounds(bounds: Bounds): void;
    frame(index: number, texels: Float32Array<ArrayBuffer>): void;
    edges(edges: Uint32Array<ArrayBuffer>): void;
    progress(progress: Progress): void;
    complete(bytes: number, milliseconds: number): void;
    error(error: NamedError): void;
}

export function startWorker(): Worker {
    return new Worker(new URL('worker.js', document.baseURI), { type: 'module' });
}

/// The module that all workers use, compiled while it comes.
export async function loadDecoder(): Promise<WebAssembly.Module> {
    const response = await fetch(new URL('decoder.wasm', document.baseURI));
    if (!response.ok) throw new Error(`decoder.wasm: ${response.status}`);
    // compileStreaming() refuses what some servers call the file.
    if (response.headers.get('content-type')?.startsWith('application/wasm')) return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
}

export class Animation {
    header: Header | null = null;
    private readonly asked = new Set<number>();
    private readonly ready = new Map<number, Float32Array<ArrayBuffer>>();
    private wanted = 0;
    private isComplete = false;
    private verifier: Worker | null = null;

    constructor(
        private readonly worker: Worker, private readonly module: WebAssembly.Module,
        private readonly source: string | Blob, private readonly listener: AnimationListener,
    ) {
        worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.take(data);
        worker.onerror = (event) =>
            listener.error({ name: 'DecoderStopped', args: [event.message ?? ''], offset: -1 });
        this.post({ kind: 'open', module, source });
    }

    close(): void {
        this.worker.onmessage = null;
        this.worker.terminate();
        this.verifier?.terminate();
    }

    askForEdges(): void {
        if (this.isComplete) this.post({ kind: 'edges' });
    }

    /// The frame, if it is there, and asks for those after it. For files that are not linear.
    want(index: number): Float32Array<ArrayBuffer> | null {
        this.wanted = index;
        const count = this.header?.frameCount ?? 1;
        for (const known of this.ready.keys()) if ((known - index + count) % count > FramesAhead) this.ready.delete(known);
        if (this.isComplete)
            for (let i = 0; i < Math.min(FramesAhead, count); ++i) {
                const frame = (index + i) % count;
                if (this.ready.has(frame) || this.asked.has(frame) || this.asked.size >= FramesAhead) continue;
                this.asked.add(frame);
                this.post({ kind: 'frame', index: frame });
            }
        return this.ready.get(index) ?? null;
    }

    private post(message: ToWorker): void {
        this.worker.postMessage(message);
    }

    private take(message: FromWorker): void {
        const { listener } = this;
        switch (message.kind) {
        case 'header':
            this.header = message.header;
            return listener.header(message.header);
        case 'mesh':
            return listener.mesh(message.mesh);
        case 'linear':
            return listener.linear(message);
        case 'bounds':
            return listener.bounds(message.bounds);
        case 'frame':
            this.asked.delete(message.index);
            this.ready.set(message.index, message.texels);
            if (message.index === this.wanted) listener.frame(message.index, message.texels);
            return;
        case 'edges':
            return listener.edges(message.edges);
        case 'progress':
            return listener.progress(message);
        case 'complete':
            this.isComplete = true;
            if (!this.header!.isLinear) void this.verify();
            return listener.complete(message.bytes, message.milliseconds);
        case 'error':
            return listener.error(message.error);
        }
    }

    /// Opening decodes the first frame alone; damage further on is told too, from a worker beside.
    private async verify(): Promise<void> {
        const blob = this.source instanceof Blob ? this.source : await (await fetch(this.source)).blob();
        this.verifier = startWorker();
        this.verifier.onmessage = ({ data }: MessageEvent<FromWorker>) => {
            if (data.kind === 'error') this.listener.error(data.error);
        };
        this.verifier.postMessage({ kind: 'verify', module: this.module, source: blob } satisfies ToWorker);
    }
}
