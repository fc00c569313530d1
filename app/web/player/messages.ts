// SPDX-License-Identifier: GPL-3.0-or-later
// What the page and its worker say to each other. Arrays are handed over, not copied.
import type { Header, NamedError } from './decoder';

export type ToWorker =
    | { kind: 'open'; module: WebAssembly.Module; source: string | Blob }
    | { kind: 'frame'; index: number }
    | { kind: 'edges' }
    /// Only answers with an error: decodes everything of `source` once.
    | { kind: 'verify'; module: WebAssembly.Module; source: Blob };

export interface Mesh {
    vertexCount: number;
    triangles: Uint32Array<ArrayBuffer>;
    cornerRanges: Uint32Array<ArrayBuffer>;
    corners: Uint32Array<ArrayBuffer>;
}

export interface Bounds {
    centre: [number, number, number];
    /// Relative to the centre.
    least: [number, number, number];
    most: [number, number, number];
}

export type FromWorker =
    | { kind: 'header'; header: Header }
    | { kind: 'mesh'; mesh: Mesh }
    | { kind: 'bounds'; bounds: Bounds }
    /// `first`: the layers from this one on; those before stay as they are.
    | { kind: 'linear'; rank: number; rows: Float32Array<ArrayBuffer>; first: number; layers: Float32Array<ArrayBuffer>[] }
    | { kind: 'frame'; index: number; texels: Float32Array<ArrayBuffer> }
    | { kind: 'edges'; edges: Uint32Array<ArrayBuffer> }
    | { kind: 'progress'; bytes: number; total: number; bands: number; bandsInFile: number }
    | { kind: 'complete'; bytes: number; milliseconds: number }
    | { kind: 'error'; error: NamedError };
