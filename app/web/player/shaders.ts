// SPDX-License-Identifier: GPL-3.0-or-later
import lighting from '../../../resources/shaders/lighting.glsl';

// Textures are laid out by app/web/decoder/texturelayout.h. Positions and normals are kept as the bits of floats in
// integer textures: every WebGL 2 can draw into those, into float textures not all.
const layout = `
ivec2 vertexTexel(uint v) { return ivec2(v & 1023u, v >> 10); }
ivec2 cornerTexel(uint c) { return ivec2(c & 2047u, c >> 11); }
`;

const precision = `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
precision highp sampler2DArray;
`;

export const cover = `${precision}
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;

/// FORMAT.md 5.4 and 13.8: mean + sum over k of trajectory k times the coefficient k of the vertex.
export const positionsPass = `${precision}
uniform sampler2DArray coefficients;
uniform sampler2D basis;
uniform int layers;
out uvec4 texel;
vec3 row(int i) { return texelFetch(basis, ivec2(i, 0), 0).xyz; }
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 place = row(0);
    for (int layer = 0; layer < layers; ++layer) {
        vec4 c = texelFetch(coefficients, ivec3(at, layer), 0);
        int k = 4 * layer + 1;
        place += c.x * row(k) + c.y * row(k + 1) + c.z * row(k + 2) + c.w * row(k + 3);
    }
    texel = uvec4(floatBitsToUint(place), 0u);
}
`;

/// Area-weighted, as model/mesh/normals.h.
export const normalsPass = `${precision}
uniform usampler2D positions;
uniform usampler2D cornerRanges;
uniform usampler2D corners;
uniform float scale; // brings products of sides into the range of floats
out uvec4 texel;
const uint MostCorners = 256u; // a file may have any number of them at a vertex
${layout}
vec3 place(uint v) { return uintBitsToFloat(texelFetch(positions, vertexTexel(v), 0).xyz); }
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 here = place(uint(at.y) * 1024u + uint(at.x));
    uvec2 range = texelFetch(cornerRanges, at, 0).xy;
    vec3 sum = vec3(0.0);
    uint end = range.x + min(range.y, MostCorners);
    for (uint corner = range.x; corner < end; ++corner) {
        uvec2 others = texelFetch(corners, cornerTexel(corner), 0).xy;
        sum += cross((place(others.x) - here) * scale, (place(others.y) - here) * scale);
    }
    float size = length(sum);
    texel = uvec4(floatBitsToUint(size > 0.0 ? sum / size : vec3(0.0, 0.0, 1.0)), 0u);
}
`;

export const drawVertex = `${precision}
uniform usampler2D positions;
uniform usampler2D normals;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float pointSize; // pixels
out vec3 vNormal;
out vec3 vPosition;
flat out vec3 vUp;
${layout}
void main() {
    ivec2 at = vertexTexel(uint(gl_VertexID));
    vec4 place = modelViewMatrix * vec4(uintBitsToFloat(texelFetch(positions, at, 0).xyz), 1.0);
    vPosition = place.xyz;
    vNormal = mat3(modelViewMatrix) * uintBitsToFloat(texelFetch(normals, at, 0).xyz);
    vUp = normalize(modelViewMatrix[1].xyz);
    gl_Position = projectionMatrix * place;
    gl_PointSize = pointSize;
}
`;

const drawFragment = `${precision}
${lighting}
uniform vec3 surface;  // linear
uniform vec3 backSide; // linear
in vec3 vNormal;
in vec3 vPosition;
flat in vec3 vUp;
out vec4 color;
`;

export const surfaceFragment = `${drawFragment}
void main() {
    vec3 normal = normalize(vNormal);
    color = encoded(lit(gl_FrontFacing ? surface : backSide, gl_FrontFacing ? normal : -normal, normalize(-vPosition), vUp));
}
`;

export const pointsFragment = `${drawFragment}
void main() {
    vec2 fromMiddle = gl_PointCoord * 2.0 - 1.0;
    if (dot(fromMiddle, fromMiddle) > 1.0)
        discard;
    vec3 toViewer = normalize(-vPosition);
    vec3 normal = normalize(vNormal);
    bool isFront = dot(normal, toViewer) >= 0.0;
    vec3 shade = lit(isFront ? surface : backSide, isFront ? normal : -normal, toViewer, vUp);
    color = encoded(isFront ? shade : shade * 0.45);
}
`;

export const linesFragment = `${precision}
${lighting}
uniform vec4 line; // linear, alpha
out vec4 color;
void main() { color = vec4(encoded(line.rgb).rgb, line.a); }
`;

export const backgroundFragment = `${precision}
${lighting}
uniform vec3 top;    // linear
uniform vec3 bottom; // linear
uniform vec2 size;   // pixels
out vec4 color;
void main() { color = vec4(encoded(mix(bottom, top, smoothstep(0.0, 1.0, gl_FragCoord.y / size.y))).rgb, 1.0); }
`;
