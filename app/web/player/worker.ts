// SPDX-License-Identifier: GPL-3.0-or-later
// Fetches and decodes one file beside the page, which ends this worker when it wants another one: nothing that a file
// does can hang the page.
import { DecodeError, Decoder } from './decoder';
import type { FromWorker, ToWorker } from './messages';

const BoundsFrames = 12;      // that the picture has to hold
const BetweenShows = 120;     // ms, while the file is coming
const LeastPart = 1024;       // bytes that are decoded at a time
const PartsOfPiece = 16;
const ValuesPerLayer = 4;     // trajectories in a texel: app/web/decoder/texturelayout.h

let decoder: Decoder | null = null;

function send(message: FromWorker, transfer: Transferable[] = []): void {
    postMessage(message, { transfer });
}

function failWith(error: unknown): void {
    if (error instanceof DecodeError) send({ kind: 'error', error: error.error });
    else if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError)
        send({ kind: 'error', error: { name: 'DecoderStopped', args: [String(error.message)], offset: -1 } });
    else send({ kind: 'error', error: { name: 'CannotLoad', args: [String((error as Error)?.message ?? error)], offset: -1 } });
}

async function streamOf(source: string | Blob): Promise<{ stream: ReadableStream<Uint8Array>; total: number }> {
    if (source instanceof Blob) return { stream: source.stream(), total: source.size };
    const response = await fetch(source);
    if (!response.ok || !response.body)
        throw new DecodeError({ name: 'CannotLoad', args: [`${response.status} ${response.statusText}`.trim()], offset: -1 });
    // The length is of what travels, which may be packed.
    const isPlain = !response.headers.get('content-encoding');
    return { stream: response.body, total: isPlain ? Number(response.headers.get('content-length') ?? 0) : 0 };
}

/// Hands on what can be shown, and what is new of it.
class Shower {
    private hasMesh = false;
    private inOrder = false;
    private rank = -1;
    private last = -Infinity;

    constructor(private readonly from: Decoder) {}

    maybe(isLast: boolean): void {
        if (!this.from.isPlayable) return;
        const header = this.from.header()!;
        const now = performance.now();
        if (this.hasMesh && !isLast && now - this.last < BetweenShows) return;
        if (this.hasMesh && header.isLinear && !isLast && this.from.bandCount + 3 <= this.rank) return;
        this.from.show();
        this.last = now;
        const isNewOrder = !this.hasMesh || this.inOrder !== this.from.keepsOrder;
        if (isNewOrder) this.mesh(header.vertexCount);
        if (header.isLinear) this.linear(isNewOrder);
        else if (!this.hasMesh) this.frame(0);
        if (!this.hasMesh || isLast) this.bounds(header.isLinear ? BoundsFrames : 1);
        this.hasMesh = true;
        this.inOrder = this.from.keepsOrder;
    }

    private mesh(vertexCount: number): void {
        const triangles = this.from.triangles();
        const cornerRanges = this.from.cornerRanges();
        const corners = this.from.corners();
        send({ kind: 'mesh', mesh: { vertexCount, triangles, cornerRanges, corners } },
             [triangles.buffer, cornerRanges.buffer, corners.buffer]);
    }

    private linear(all: boolean): void {
        const rank = this.from.rank;
        if (rank === this.rank && !all) return;
        // The last layer that went out may have had room for more.
        const first = all || this.rank < 0 ? 0 : Math.floor(this.rank / ValuesPerLayer);
        const layers: Float32Array<ArrayBuffer>[] = [];
        for (let layer = first; layer < this.from.layerCount; ++layer) layers.push(this.from.coefficients(layer));
        const rows = this.from.basis();
        this.rank = rank;
        send({ kind: 'linear', rank, rows, first, layers }, [rows.buffer, ...layers.map((layer) => layer.buffer)]);
    }

    frame(index: number): void {
        const texels = this.from.frame(index);
        send({ kind: 'frame', index, texels }, [texels.buffer]);
    }

    bounds(frames: number): void {
        const [cx, cy, cz, ...box] = this.from.bounds(frames);
        const relative = (at: number): [number, number, number] => [box[at] - cx, box[at + 1] - cy, box[at + 2] - cz];
        send({ kind: 'bounds', bounds: { centre: [cx, cy, cz], least: relative(0), most: relative(3) } });
    }
}

async function open(module: WebAssembly.Module, source: string | Blob): Promise<void> {
    const { stream, total } = await streamOf(source);
    const opened = new Decoder(module);
    const shower = new Shower(opened);
    const reader = stream.getReader();
    let milliseconds = 0;
    let hasHeader = false;
    for (;;) {
        const { done, value } = await reader.read();
        const begin = performance.now();
        if (done) opened.finish();
        // In parts, so that the first picture is not for the end of what came at once.
        const part = Math.max(LeastPart, Math.ceil((value?.length ?? 0) / PartsOfPiece));
        for (let at = 0; value && at < value.length; at += part) {
            opened.append(value.subarray(at, at + part));
            if (!hasHeader && opened.header()) {
                hasHeader = true;
                send({ kind: 'header', header: opened.header()! });
            }
            shower.maybe(opened.bytesRead === total);
        }
        if (done) shower.maybe(true);
        milliseconds += performance.now() - begin;
        send({ kind: 'progress', bytes: opened.bytesRead, total, bands: opened.bandCount, bandsInFile: opened.bandsInFile });
        if (done) break;
    }
    decoder = opened;
    send({ kind: 'complete', bytes: opened.bytesRead, milliseconds });
    // Far frames of a file that is decoded frame by frame cost more: after the first picture.
    if (!opened.header()!.isLinear) shower.bounds(4);
}

async function verify(module: WebAssembly.Module, source: Blob): Promise<void> {
    const opened = new Decoder(module);
    opened.append(new Uint8Array(await source.arrayBuffer()));
    opened.show();
    opened.check();
}

onmessage = ({ data }: MessageEvent<ToWorker>) => {
    try {
        if (data.kind === 'open') open(data.module, data.source).catch(failWith);
        else if (data.kind === 'verify') verify(data.module, data.source).catch(failWith);
        else if (decoder && data.kind === 'frame') new Shower(decoder).frame(data.index);
        else if (decoder && data.kind === 'edges') {
            const edges = decoder.edges();
            send({ kind: 'edges', edges }, [edges.buffer]);
        }
    } catch (error) {
        failWith(error);
    }
};
