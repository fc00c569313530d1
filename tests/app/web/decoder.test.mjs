// SPDX-License-Identifier: GPL-3.0-or-later
// The decoder in WebAssembly against the positions that are pinned for the decoder in C++.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { data, decoderModule, pinnedFrames, pinnedPositions } from './support.mjs';

const MostError = 1e-5; // of the diagonal
const Named = /^(Truncated|TrailingBytes|BadMagic|UnsupportedVersion|UnsupportedFeature|ChecksumMismatch|MissingChunk|DuplicateChunk|BadValue|UnknownCodec|CorruptStream|LimitExceeded|OutOfMemory)$/;
const names = readdirSync(join(data, 'anim')).filter((file) => file.endsWith('.anim')).map((file) => file.slice(0, -5));

let Decoder, module;
before(async () => ({ Decoder, module } = await decoderModule()));

const bytesOf = (name) => new Uint8Array(readFileSync(join(data, 'anim', `${name}.anim`)));

function opened(bytes, piece = bytes.length) {
    const decoder = new Decoder(module);
    for (let at = 0; at < bytes.length; at += piece) decoder.append(bytes.subarray(at, at + piece));
    decoder.finish();
    decoder.show();
    return decoder;
}

const allFrames = (decoder) => Array.from({ length: decoder.header().frameCount }, (_, frame) => frame);

/// Frames of a decoder, x y z of each vertex, absolute.
function positionsOf(decoder, frames = allFrames(decoder)) {
    const { vertexCount } = decoder.header();
    const centre = decoder.bounds(1).slice(0, 3);
    const all = new Float64Array(3 * vertexCount * frames.length);
    frames.forEach((frame, i) => {
        const texels = decoder.frame(frame);
        for (let v = 0; v < vertexCount; ++v)
            for (let axis = 0; axis < 3; ++axis) all[3 * (i * vertexCount + v) + axis] = texels[4 * v + axis] + centre[axis];
    });
    return all;
}

/// The same from what the GPU gets.
function productOf(decoder, frames = allFrames(decoder)) {
    const { frameCount, vertexCount } = decoder.header();
    const centre = decoder.bounds(1).slice(0, 3);
    const rows = decoder.basis();
    const stride = rows.length / frameCount;
    const layers = Array.from({ length: decoder.layerCount }, (_, layer) => decoder.coefficients(layer));
    const all = new Float64Array(3 * vertexCount * frames.length);
    frames.forEach((frame, i) => {
        for (let v = 0; v < vertexCount; ++v)
            for (let axis = 0; axis < 3; ++axis) {
                let sum = rows[frame * stride + axis] + centre[axis];
                layers.forEach((layer, l) => {
                    for (let k = 0; k < 4; ++k) sum += layer[4 * v + k] * rows[frame * stride + 4 * (1 + 4 * l + k) + axis];
                });
                all[3 * (i * vertexCount + v) + axis] = sum;
            }
    });
    return all;
}

function assertClose(actual, expected) {
    assert.equal(actual.length, expected.length);
    let least = [Infinity, Infinity, Infinity], most = [-Infinity, -Infinity, -Infinity], worst = 0;
    expected.forEach((value, i) => {
        least[i % 3] = Math.min(least[i % 3], value);
        most[i % 3] = Math.max(most[i % 3], value);
        worst = Math.max(worst, Math.abs(value - actual[i]));
    });
    const diagonal = Math.hypot(...most.map((value, axis) => value - least[axis]));
    assert.ok(worst <= MostError * diagonal, `${worst / diagonal} of the diagonal`);
}

function errorOf(action) {
    try {
        action();
    } catch (error) {
        return error.error?.name ?? `${error}`;
    }
    return null;
}

describe('positions', () => {
    test('all four codecs are among the pinned files', () => {
        const codecs = new Set(names.map((name) => opened(bytesOf(name)).header().codec));
        assert.deepEqual([...codecs].sort(), [1, 2, 3, 4]);
    });
    for (const name of names) {
        test(`${name} has the positions of the decoder in C++`, () => assertClose(positionsOf(opened(bytesOf(name)), pinnedFrames[name]), pinnedPositions(name)));
        test(`${name} in pieces of 7 bytes is the same`, () =>
            assert.deepEqual(positionsOf(opened(bytesOf(name), 7)), positionsOf(opened(bytesOf(name)))));
        test(`${name} has these positions for the GPU too`, (context) => {
            const decoder = opened(bytesOf(name));
            if (!decoder.header().isLinear) return context.skip('decoded frame by frame');
            assertClose(productOf(decoder, pinnedFrames[name]), pinnedPositions(name));
        });
        test(`the mesh of ${name} is whole`, () => {
            const decoder = opened(bytesOf(name));
            const { vertexCount, triangleCount } = decoder.header();
            const triangles = decoder.triangles(), ranges = decoder.cornerRanges(), corners = decoder.corners();
            assert.equal(triangles.length, 3 * triangleCount);
            const around = Array.from({ length: vertexCount }, () => []);
            const edges = new Set();
            for (let t = 0; t < triangles.length; t += 3)
                for (let i = 0; i < 3; ++i) {
                    const [a, b, c] = [0, 1, 2].map((j) => triangles[t + ((i + j) % 3)]);
                    around[a].push(`${b} ${c}`);
                    if (a !== b) edges.add([a, b].sort((x, y) => x - y).join(' '));
                }
            around.forEach((expected, v) => {
                const [first, count] = ranges.slice(2 * v, 2 * v + 2);
                const found = Array.from({ length: count }, (_, i) => `${corners[2 * (first + i)]} ${corners[2 * (first + i) + 1]}`);
                assert.deepEqual(found.sort(), expected.sort());
            });
            const ends = decoder.edges();
            assert.deepEqual(new Set(Array.from({ length: ends.length / 2 }, (_, e) => `${ends[2 * e]} ${ends[2 * e + 1]}`)), edges);
        });
    }
});

describe('damage', () => {
    for (const name of names) {
        test(`every beginning of ${name} is Truncated`, () => {
            const bytes = bytesOf(name);
            for (let length = 0; length < bytes.length; length += 1 + Math.floor(bytes.length / 60))
                assert.equal(errorOf(() => opened(bytes.subarray(0, length))), 'Truncated', `${length} bytes`);
        });
        test(`changed bytes of ${name} give a named error or none`, () => {
            const bytes = bytesOf(name);
            for (let at = 0; at < bytes.length; at += 1 + Math.floor(bytes.length / 60)) {
                const changed = bytes.slice();
                changed[at] ^= 1 << at % 8;
                assert.match(errorOf(() => opened(changed).check()) ?? 'none', Named, `byte ${at}`);
            }
        });
    }
    test('a byte too many is TrailingBytes', () => {
        assert.equal(errorOf(() => opened(new Uint8Array([...bytesOf('reel-1.0'), 0]))), 'TrailingBytes');
    });
    test('text is BadMagic', () => {
        assert.equal(errorOf(() => opened(new TextEncoder().encode('not an animation, but long enough'))), 'BadMagic');
    });
    for (const file of readdirSync(join(data, 'hostile')).filter((name) => name.endsWith('.anim')))
        test(`hostile/${file} gives a named error or none`, () => {
            const bytes = new Uint8Array(readFileSync(join(data, 'hostile', file)));
            assert.match(errorOf(() => opened(bytes).check()) ?? 'OutOfMemory', Named);
        });
});
